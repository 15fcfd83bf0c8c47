// SPDX-License-Identifier: BSD-3-Clause
// Vertices named on the command line: "0-99,120".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// First and last id, both included.
using IdRange = std::pair<Id, Id>;

/// Throws InvalidArgument unless the text is a comma-separated list of ids and ranges.
std::vector<IdRange> parse_id_ranges(const std::string& text);

/// The vertices in the ranges, sorted by id, each once. Throws InvalidArgument, naming `option`, if an id or
/// a range has no vertex.
std::vector<VertexRef> find_vertices(const Graph& graph, const std::vector<IdRange>& ranges,
                                     const std::string& option);

}  // namespace boxplus::app
