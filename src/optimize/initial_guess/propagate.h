// SPDX-License-Identifier: BSD-3-Clause
// Sets frames one from the other, along the shortest paths from the roots.
#pragma once

#include <span>

#include "optimize/initial_guess/components.h"

namespace boxplus::guess {

/// Dijkstra's algorithm over the measurements, measurement k costing `cost[k]` > 0. Moves every movable
/// vertex that a root reaches; where none does, the pose of lowest id becomes one. Equal costs are settled by
/// node index.
///
/// Throws Stopped once the token is raised; some vertices have moved then.
void propagate(FrameGraph& frames, std::span<const double> cost, const StopToken& stop);

}  // namespace boxplus::guess
