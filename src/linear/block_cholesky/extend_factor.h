// SPDX-License-Identifier: BSD-3-Clause
// A symbolic factorization that grows with its structure.
#pragma once

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Appends the new blocks of the structure to the end of the elimination order. Each becomes a front; the
/// only old fronts that change are those on the paths from its neighbors to the roots, whose rows it joins.
/// Takes O(old fronts) light steps, and the work of an analysis for the fronts on the paths only.
///
/// False, and nothing has changed, if more than 16 blocks are new, or if a new off-diagonal block between old
/// ones is not in the pattern of the factor.
bool extend_factor(const BlockStructure& structure, const StructureGrowth& growth, SymbolicFactor& factor);

/// Predicted for one factorization on one thread.
double predicted_nanoseconds(const SymbolicFactor& factor, const AmalgamationRule& rule);

}  // namespace boxplus
