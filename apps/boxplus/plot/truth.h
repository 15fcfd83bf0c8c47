// SPDX-License-Identifier: BSD-3-Clause
// Reads the true positions of a graph's poses, for drawing.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Returns the positions of the poses in the graph file `truth`. Aligns them with the poses of `graph` that
/// have the same ids, like `boxplus compare`. Messages call the graph `name`. Throws the same exceptions as
/// read_truth() and trajectory_of(), and FileError if the two graphs have no id in common.
TruePlaces true_places(const Graph& graph, const std::string& name, const std::string& truth,
                       const ReadOptions& reading);

}  // namespace boxplus::app
