// SPDX-License-Identifier: BSD-3-Clause
// Divides a graph among processes.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::mpi {

/// The edges of one of `parts` parts of a graph, which have about equal numbers of edges. Vertices that are
/// not eliminated are cut by id. An eliminated vertex, with all of its edges, belongs to the part with most
/// of these edges, unless that is full. Another edge belongs to the part of its vertex with the lowest id.
/// Depends only on the graph. O(n log n).
std::vector<EdgeRef> edges_of_part(const Graph& graph, int part, int parts);

/// The same division, without a graph, if each edge has one eliminated vertex and one other: the part of each
/// eliminated vertex. `pairs` has (eliminated vertex << 32) + other vertex for each edge, both numbered in
/// the order of ids from 0 on. They are overwritten.
std::vector<std::uint32_t> parts_of_eliminated(std::vector<std::uint64_t>& pairs, std::uint32_t eliminated,
                                               std::uint32_t kept, int parts);

}  // namespace boxplus::mpi
