// SPDX-License-Identifier: BSD-3-Clause
// Extends a symbolic factorization when the structure of H grows.
#pragma once

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Appends the new blocks of the structure to the end of the elimination order. Each new block becomes a
/// front. Of the old fronts, only those on the paths from the neighbors of the new block to the roots change:
/// their rows now include the new block. Takes O(old fronts) cheap steps, and the time of an analysis for the
/// fronts on these paths.
///
/// Returns false and changes nothing if more than 16 blocks are new, or if a new off-diagonal block between
/// old blocks is not in the pattern of the factor.
bool extend_factor(const BlockStructure& structure, const StructureGrowth& growth, SymbolicFactor& factor);

/// The predicted time of one factorization on one thread, in nanoseconds.
double predicted_nanoseconds(const SymbolicFactor& factor, const AmalgamationRule& rule);

}  // namespace boxplus
