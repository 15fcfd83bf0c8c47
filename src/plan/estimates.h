// SPDX-License-Identifier: BSD-3-Clause
// A copy of the estimates of a plan's active vertices.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

class Estimates {
 public:
  Estimates() = default;
  Estimates(const Graph& graph, const Plan& plan) { take(graph, plan); }

  /// Copies the estimates from the graph. Allocates nothing if the last take() was for the same plan.
  void take(const Graph& graph, const Plan& plan);
  /// Copies the estimates back to the graph. `plan` must be the plan of the last take().
  void put_back(Graph& graph, const Plan& plan) const;

 private:
  struct Part {
    std::uint32_t pool = 0;
    std::unique_ptr<detail::SavedEstimates> estimates;
  };
  std::vector<Part> parts_;  // one part for each list of Plan::vertices
};

}  // namespace boxplus
