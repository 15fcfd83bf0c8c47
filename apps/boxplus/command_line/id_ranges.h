// SPDX-License-Identifier: BSD-3-Clause
// Finds the vertices that the user lists on the command line, for example as "0-99,120".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// The first and the last id of a range; both belong to the range.
using IdRange = std::pair<Id, Id>;

/// Parses a comma-separated list of ids and ranges. Throws InvalidArgument if the text is anything else.
std::vector<IdRange> parse_id_ranges(const std::string& text);

/// Returns the vertices whose ids are in the ranges, sorted by id and without duplicates. Throws
/// InvalidArgument if the graph has no vertex for one of the ids or ranges. The message begins with `option`.
std::vector<VertexRef> find_vertices(const Graph& graph, const std::vector<IdRange>& ranges,
                                     const std::string& option);

}  // namespace boxplus::app
