// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace boxplus {

/// Sum by halving: the error grows with log n (Higham, "The accuracy of floating point summation", 1993), and
/// the order is fixed by n alone.
double pairwise_sum(std::span<const double> values);

}  // namespace boxplus
