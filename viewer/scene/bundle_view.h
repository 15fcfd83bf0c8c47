// SPDX-License-Identifier: BSD-3-Clause
// How a graph of bundle adjustment is seen.
#pragma once

#include <array>

#include "boxplus/graph/graph.h"

namespace boxplus::viewer {

/// Returns true if all edges are reprojection errors, and there is at least one.
bool is_bundle(const Graph& graph);

/// Returns the rotation of the world (row-major) after which the cameras on average look along y, and their
/// tops point to z. Without cameras, it is the identity.
std::array<double, 9> leveling(const Graph& graph);

}  // namespace boxplus::viewer
