// SPDX-License-Identifier: BSD-3-Clause
// The data that a file attaches to vertices (boxplus/io/data.h): laser scans, ellipses and names.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Adds the data of the vertices to the scene of the graph, at the estimates: the points that lasers have
/// hit, the 95 % ellipses and the points that may match, and the names. Enlarges the scene accordingly.
/// Throws InputError if a line of data is malformed; if `lenient` is true, prints a message instead and
/// leaves the line out. `name` is the name of the file.
void add_data(Scene& scene, const GraphFile& file, const View& view, const std::string& name, bool lenient);

}  // namespace boxplus::app
