// SPDX-License-Identifier: BSD-3-Clause
// The estimate of a vertex as text, for types that have no tag in .g2o files.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::viewer {

/// A line each for the position, the rotation (a quaternion, x y z w) and, if the vertex is a camera or a
/// pose with a camera, for each parameter of the camera, with its name. "" if the type has nothing of this.
std::string estimate_text(const Graph& graph, VertexRef vertex);

}  // namespace boxplus::viewer
