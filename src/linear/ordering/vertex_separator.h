// SPDX-License-Identifier: BSD-3-Clause
// Finds a small set of vertices that separates a graph into two parts of about the same weight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/base/stop_token.h"

namespace boxplus {

/// An undirected graph. Vertex v has the neighbors neighbor[start[v]] … neighbor[start[v + 1] − 1]. Each
/// neighbor is listed once, and no vertex is its own neighbor.
struct WeightedGraph {
  std::vector<std::uint32_t> start{0}, neighbor;
  std::vector<std::int64_t> edge_weight;  // the weight of the edge to each element of `neighbor`
  std::vector<std::int64_t> weight;       // the weight of each vertex

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(weight.size()); }
  std::span<const std::uint32_t> neighbors(std::uint32_t v) const {
    return std::span(neighbor).subspan(start[v], start[v + 1] - start[v]);
  }
  std::int64_t total() const;
};

/// The side of a vertex. No edge joins the two sides.
enum Side : std::uint8_t { kLeft, kRight, kSeparator };

/// Finds a vertex separator by a multilevel method (Karypis and Kumar, "A fast and high quality multilevel
/// scheme for partitioning irregular graphs", 1998). It coarsens the graph by heavy-edge matching, divides
/// the coarsest graph by growing one side, and refines the separator on every level on the way back. The
/// refinement follows Fiduccia and Mattheyses 1982 and Ashcraft and Liu 1998. The result is the same in every
/// run. Takes O(edges · log(vertices)). Throws Stopped when the token is raised.
std::vector<Side> find_separator(const WeightedGraph& graph, const StopToken& stop = {});

}  // namespace boxplus
