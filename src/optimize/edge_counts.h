// SPDX-License-Identifier: BSD-3-Clause
// Counts the active edges of a plan by their present state.
#pragma once

#include <cstdint>

#include "plan/plan.h"

namespace boxplus {

struct EdgeCounts {
  std::uint64_t rows = 0;  ///< of the errors of the enabled edges
  std::uint32_t disabled = 0;
  std::uint32_t robust = 0;  ///< enabled edges that have a robust kernel
};

/// O(edges).
EdgeCounts count_edges(const Graph& graph, const Plan& plan);

}  // namespace boxplus
