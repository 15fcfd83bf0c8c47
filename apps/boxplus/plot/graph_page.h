// SPDX-License-Identifier: BSD-3-Clause
// A graph as a page that needs no server.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Returns the page of `boxplus view` with the graph inside: one HTML file that loads nothing from elsewhere.
/// The page shows the graph under the name `name`, but cannot change it. The graph must have estimates.
std::string make_graph_page(GraphFile file, const std::string& name);

}  // namespace boxplus::app
