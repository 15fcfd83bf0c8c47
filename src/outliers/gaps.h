// SPDX-License-Identifier: BSD-3-Clause
// Closures that connect the parts into which gaps divide the odometry.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "outliers/cycle_test.h"

namespace boxplus::outliers {

struct Bridges {
  std::vector<std::uint32_t> supported;    ///< closures that another closure supports
  std::vector<std::uint32_t> unsupported;  ///< other closures; only these connect two parts
};

/// Chooses the closures with the most support that connect the parts of the odometry (a spanning tree). Parts
/// that other edges or fixed vertices connect need none.
Bridges bridge_gaps(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                    const CycleTests& cycles, double evidence);

/// Whether the accepted closures connect fewer parts of the odometry than all closures do.
bool leaves_parts_apart(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                        std::span<const std::uint8_t> accepted);

}  // namespace boxplus::outliers
