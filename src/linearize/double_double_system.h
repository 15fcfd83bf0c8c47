// SPDX-License-Identifier: BSD-3-Clause
// H and the gradient with 32 digits.
#pragma once

#include <vector>

#include "base/double_double.h"
#include "linearize/linearizer.h"

namespace boxplus {

struct DoubleDoubleSystem {
  std::vector<DoubleDouble> values;  ///< of all columns of H, as in Plan::structure
  std::vector<DoubleDouble> gradient;
};

/// Computes H and the gradient at the current estimates as Linearizer does, but sums and multiplies in
/// double-double. The errors, Jacobians and Ω of the edges are doubles. If their rounding perturbs a row of J
/// by a relative error ε, then this changes what the row measures by ε, however large its weight is. But in a
/// sum in double, a row of weight 1e16 deletes the rows of weight 1. Takes one thread and O(edges). May throw
/// Stopped.
void linearize_in_double_double(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                const StopToken& stop, DoubleDoubleSystem& system);

}  // namespace boxplus
