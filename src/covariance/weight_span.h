// SPDX-License-Identifier: BSD-3-Clause
// Names the lightest and the heaviest weight of a graph.
#pragma once

#include <string>

#include "plan/plan.h"

namespace boxplus {

/// The smallest and the largest positive diagonal entry of the Ω of all enabled edges of the plan.
struct WeightSpan {
  double least = 0, most = 0;
  EdgeRef lightest, heaviest;
  double digits() const;
};

WeightSpan weight_span(const Graph& graph, const Plan& plan);
/// "the weights span 14.6 digits, from 1e-08 (Prior<SE3>, vertex 1) to 4e+06 (Between<SE3>, vertices 1 2)"
std::string to_string(const WeightSpan& span, const Graph& graph);

}  // namespace boxplus
