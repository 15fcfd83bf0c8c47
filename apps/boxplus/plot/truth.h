// SPDX-License-Identifier: BSD-3-Clause
// The true positions of a graph's poses, for drawing.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "plot/scene.h"

namespace boxplus::app {

/// The positions of the poses in the graph file `truth`, aligned with the poses of `graph` with the same ids,
/// as `boxplus compare` does; messages call the graph `name`. Throws the exceptions of read_trajectory(), and
/// FileError if the two have no id in common.
TruePlaces true_places(const Graph& graph, const std::string& name, const std::string& truth,
                       const ReadOptions& reading);

}  // namespace boxplus::app
