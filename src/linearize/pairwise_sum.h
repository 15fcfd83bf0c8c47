// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace boxplus {

/// The sum of the n values, by recursive halving. Its rounding error grows only with log n (Higham, "The
/// accuracy of floating point summation", 1993), and the order of the additions depends only on n.
double pairwise_sum(std::span<const double> values);

}  // namespace boxplus
