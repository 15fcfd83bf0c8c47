// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

/// Finds the parts of the active graph that hang on rejected edges alone: without these edges, they would be
/// disconnected from the fixed vertices, or free. The plan's held vertices count as fixed. If nothing fixes a
/// connected component, the largest of its parts counts as fixed. `rejected` has a flag for each active edge,
/// in the order of the plan. Returns one vertex of each part, in the order of ids: the one with the lowest
/// id. O(vertices + edges).
std::vector<VertexRef> find_cut_off(const Graph& graph, const Plan& plan,
                                    std::span<const std::uint8_t> rejected);

}  // namespace boxplus
