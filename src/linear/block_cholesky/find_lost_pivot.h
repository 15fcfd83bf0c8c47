// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "linear/block_cholesky/numeric_factor.h"

namespace boxplus {

/// Applies the test that is described at kLostPivot to the suspects of the last factorization. Returns the
/// first lost pivot in the elimination order, or the number of scalars if no pivot is lost.
template <class Scalar>
std::uint32_t find_lost_pivot(const SymbolicFactor& symbolic, const BlockStructure& structure,
                              NumericFactor<Scalar>& factor);

}  // namespace boxplus
