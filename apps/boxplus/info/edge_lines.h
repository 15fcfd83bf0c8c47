// SPDX-License-Identifier: BSD-3-Clause
// Where the edges of a graph stand in its file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// The line of each of file.edges in the text that `file` was read from. Empty where that is not certain,
/// because lines with edges were left out.
std::vector<std::int64_t> find_edge_lines(std::string_view text, const GraphFile& file,
                                          const ReadOptions& reading);

}  // namespace boxplus::app
