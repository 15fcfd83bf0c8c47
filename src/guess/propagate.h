// SPDX-License-Identifier: BSD-3-Clause
// Sets frames along the shortest paths from the roots.
#pragma once

#include <span>

#include "guess/components.h"

namespace boxplus::guess {

/// Runs Dijkstra's algorithm over the measurements. Measurement k has the length cost[k] > 0. Moves every
/// movable vertex that can be reached from a root. In a part that no root reaches, the pose with the lowest
/// id becomes a root. At equal distances, the node with the lower index comes first.
///
/// Throws Stopped when the token is raised. Some vertices may have moved by then.
void propagate(FrameGraph& frames, std::span<const double> cost, const StopToken& stop);

}  // namespace boxplus::guess
