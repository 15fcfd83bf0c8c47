// SPDX-License-Identifier: BSD-3-Clause
// Sets frames along the shortest paths from the roots.
#pragma once

#include <span>

#include "optimize/initial_guess/components.h"

namespace boxplus::guess {

/// Dijkstra's algorithm over the measurements; measurement k has the length `cost[k]` > 0. Moves every
/// movable vertex that a root reaches. In a part that no root reaches, the pose of lowest id becomes a root.
/// Among equal costs, the lower node index comes first.
///
/// Throws Stopped when the token is raised; some vertices have moved then.
void propagate(FrameGraph& frames, std::span<const double> cost, const StopToken& stop);

}  // namespace boxplus::guess
