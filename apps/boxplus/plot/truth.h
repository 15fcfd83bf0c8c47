// SPDX-License-Identifier: BSD-3-Clause
// The true places of a graph's poses, to draw them beside it.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "plot/scene.h"

namespace boxplus::app {

/// The places of the poses in the graph file `truth`, moved as a whole to where they fit the poses of `graph`
/// with the same ids best, as `boxplus compare` does; `name` stands for the graph in messages. Throws what
/// read_trajectory() throws, and FileError if no id is in both.
TruePlaces true_places(const Graph& graph, const std::string& name, const std::string& truth,
                       const ReadOptions& reading);

}  // namespace boxplus::app
