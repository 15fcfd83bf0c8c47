// SPDX-License-Identifier: BSD-3-Clause
// Reads the true positions of a graph's poses, for drawing.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Returns the positions of the poses in the graph file `truth`, by the ids of the graph `file`. Matches them
/// with the poses of `file` and aligns them, like `boxplus compare`; with bundle adjustment, whose scale is
/// free, like `boxplus compare --scale`. Messages call the graph `name`. Throws the same exceptions as
/// read_truth() and trajectory_of(), and FileError if no poses match.
TruePlaces true_places(const GraphFile& file, const std::string& name, const std::string& truth,
                       const ReadOptions& reading);

}  // namespace boxplus::app
