// SPDX-License-Identifier: BSD-3-Clause
// What all formats with tags (.g2o, JSON) have in common when they write a graph.
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/io/registry.h"

namespace boxplus {

/// The tag with which an element is written. Throws InvalidArgument if its type has no tag.
const Tag& tag_to_write(const Registry& registry, const Graph& graph, VertexRef vertex);
const Tag& tag_to_write(const Registry& registry, const Graph& graph, EdgeRef edge);

/// The ids that a file lists for an edge with this tag: those of its vertices, then those of its parameters.
/// A parameter that the edge uses twice is listed twice, although the graph has it once.
std::vector<Id> ids_to_write(const Registry& registry, const Graph& graph, const Tag& tag, EdgeRef edge);

}  // namespace boxplus
