// SPDX-License-Identifier: BSD-3-Clause
// Graphs without data association, for tests of programs that find it.
#pragma once

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Replaces what an edge has measured by the vertex id −1, so that the edge becomes a line that .g2o files
/// keep but that is not part of the graph (docs/formats.md):
///   - in an edge of a pose with landmarks (points, lines, segments, planes): all landmarks;
///   - in an edge of two landmarks, and in a loop closure (two poses whose ids are not next to each other):
///   the
///     last of its vertices.
/// All other edges, and all vertices, stay. Returns the number of changed edges. Throws InvalidArgument if
/// the graph cannot be written as .g2o.
std::size_t anonymize(GraphFile& file);

}  // namespace boxplus::app
