// SPDX-License-Identifier: BSD-3-Clause
// Finds the line numbers of the edges in a graph file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Returns the line number of each edge in `file.edges`. `text` is the text from which `file` was read.
/// If the number of lines with edges differs from the number of edges, the line numbers are uncertain, and
/// the result is empty.
std::vector<std::int64_t> find_edge_lines(std::string_view text, const GraphFile& file,
                                          const ReadOptions& reading);

}  // namespace boxplus::app
