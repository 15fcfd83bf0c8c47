// SPDX-License-Identifier: BSD-3-Clause
// A small set of vertices that separates a graph into two parts of about the same weight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/base/stop_token.h"

namespace boxplus {

/// An undirected graph. Vertex v has the neighbors neighbor[start[v]] … neighbor[start[v + 1] − 1], each
/// once, and never itself.
struct WeightedGraph {
  std::vector<std::uint32_t> start{0}, neighbor;
  std::vector<std::int64_t> edge_weight;  // of each neighbor
  std::vector<std::int64_t> weight;       // of each vertex

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(weight.size()); }
  std::span<const std::uint32_t> neighbors(std::uint32_t v) const {
    return std::span(neighbor).subspan(start[v], start[v + 1] - start[v]);
  }
  std::int64_t total() const;
};

/// The side of a vertex. No edge joins the two sides.
enum Side : std::uint8_t { kLeft, kRight, kSeparator };

/// A multilevel vertex separator. The graph is coarsened by heavy-edge matching, the coarsest graph is parted
/// by growing one side, and the separator is refined on every level on the way back (Karypis and Kumar, "A
/// fast and high quality multilevel scheme for partitioning irregular graphs", 1998; the refinement after
/// Fiduccia and Mattheyses 1982 and Ashcraft and Liu 1998). The labels are the same in every run. O(edges log
/// vertices). Throws Stopped when the token is raised.
std::vector<Side> find_separator(const WeightedGraph& graph, const StopToken& stop = {});

}  // namespace boxplus
