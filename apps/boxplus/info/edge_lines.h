// SPDX-License-Identifier: BSD-3-Clause
// The lines of the edges in a graph file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// The line of each edge of file.edges in the text from which `file` was read. Empty if skipped lines with
/// edges make the lines uncertain.
std::vector<std::int64_t> find_edge_lines(std::string_view text, const GraphFile& file,
                                          const ReadOptions& reading);

}  // namespace boxplus::app
