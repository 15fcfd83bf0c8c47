// SPDX-License-Identifier: BSD-3-Clause
// The structure of the picture of a graph: the types of its vertices and edges, and the vertices of each
// edge.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"
#include "graph/graph_view.h"

namespace boxplus::viewer {

enum class Shape : std::uint8_t {
  kPose,
  kCamera,      ///< a camera that looks along z of its frame
  kCameraBack,  ///< a camera that looks along −z of its frame
  kPoint,
  kCorner  ///< only the end of lines
};

/// The drawn vertices of one pool. Their numbers are first, first + 1, …, in the order of `slots`.
struct VertexGroup {
  std::string name;
  Shape shape;
  std::uint32_t pool, first;
  std::vector<std::uint32_t> slots;
  std::string color = {};  ///< the default color, as #rrggbb; empty: that of the page
};

/// The lines of the edges of one type and role: pairs first, first + 1, … of Structure::lines.
struct LineGroup {
  std::string name;
  EdgeRole role;
  std::uint32_t pool, first, count;
  std::string color = {};  ///< as for vertices
};

struct Structure {
  std::uint64_t revision = 0;  ///< Graph::revision() of the graph
  int dimension = 2;           ///< 3 if any vertex is in space
  bool is_bundle = false;
  std::array<double, 9> leveling{1, 0, 0, 0, 1, 0, 0, 0, 1};
  /// Poses and cameras, then points, then corners. A type that is neither a pose nor a point is not drawn.
  std::vector<VertexGroup> vertices;
  std::vector<LineGroup> line_groups;
  /// The numbers of the two vertices of each line. An edge with n drawn vertices has n − 1 lines, all from
  /// the first of them.
  std::vector<std::uint32_t> lines;
  std::vector<std::uint32_t> line_edges;  ///< the slot of each line's edge in the pool of its group
  std::uint64_t left_out = 0;             ///< lines beyond kMostLines
  std::vector<std::uint8_t> fixed;        ///< per vertex
  /// In bundle adjustment, the number of observations of each point; the first belongs to vertex `oriented`.
  std::vector<std::uint32_t> track_lengths;
  std::uint32_t count = 0, oriented = 0;  ///< all drawn vertices; poses and cameras among them
  std::array<double, 3> center{};         ///< near the middle of the vertices when the structure was made

  static constexpr std::uint32_t kMostLines = 4'000'000;
};

/// Which elements are drawn: all, or those that take part: edges of level 0, and vertices that have one or
/// have no edge at all.
enum class Drawn : std::uint8_t { kAll, kTakingPart };

/// O(n log n) in the vertices, O(n) in the edges.
Structure make_structure(const Graph& graph, Drawn drawn = Drawn::kAll);

}  // namespace boxplus::viewer
