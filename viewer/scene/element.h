// SPDX-License-Identifier: BSD-3-Clause
// One vertex or edge of a graph: how it is named in requests, and what there is to say about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxplus/graph/graph.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

/// Names a vertex or an edge of a graph with a certain structure.
struct ElementName {
  enum class Kind : std::uint8_t {
    kVertex,  ///< the number of a drawn vertex
    kId,      ///< the id of a vertex, which need not be drawn
    kLine,    ///< the number of a line of an edge
    kEdge     ///< the number of an edge, as EdgeFacts::number
  };
  Kind kind;
  std::uint64_t number;
};

using Element = std::variant<VertexRef, EdgeRef>;

/// Throws InvalidArgument if the graph has no such element.
Element find_element(const Graph& graph, const Structure& structure, const ElementName& name);

struct EdgeFacts {
  struct End {
    Id id;
    std::string type;
    bool is_parameter;
    std::optional<std::uint32_t> number;  ///< if the vertex is drawn
  };
  EdgeRef edge;
  std::uint64_t number;               ///< among all slots of all pools of edges
  std::optional<std::uint32_t> line;  ///< its first line, if it is drawn
  std::string type, tag;              ///< the tag is "" if the type has none
  std::string fields;                 ///< measurement and Ω as in a file with tags, or ""
  std::vector<End> ends;              ///< at most kMostListed
  std::size_t vertices;
  int rows, level;
  std::vector<double> error;  ///< at most kMostListed numbers
  double chi2;                ///< before the kernel
  double weight;              ///< as Graph::weight()
  std::string kernel;         ///< its name, or ""
  bool is_enabled;

  double chi2_per_row() const { return chi2 / (rows > 0 ? rows : 1); }
};

struct VertexFacts {
  Id id;
  std::optional<std::uint32_t> number;  ///< if it is drawn
  std::string type, tag;                ///< the tag is "" if the type has none
  std::string estimate;                 ///< as in a file with tags; without a tag, as estimate_text()
  bool is_fixed;
  std::vector<int> fixed_directions;
  std::size_t edge_count;
  std::vector<EdgeFacts> edges;  ///< at most kMostListed, with the largest chi2 per row first
};

inline constexpr std::size_t kMostListed = 100;

/// The number of a drawn vertex.
std::optional<std::uint32_t> number_of(const Structure& structure, VertexRef vertex);
/// The lines first, first + 1, … of an edge.
struct Lines {
  std::uint32_t first = 0, count = 0;
};
/// O(log n); none if the edge is not drawn.
Lines lines_of(const Structure& structure, EdgeRef edge);
/// The number of an edge: EdgeFacts::number.
std::uint64_t number_of(const Graph& graph, EdgeRef edge);

/// The first call for a graph takes O(vertices + edges), others O(d log d) for d edges.
VertexFacts facts_of(const Graph& graph, const Structure& structure, VertexRef vertex);
EdgeFacts facts_of(const Graph& graph, const Structure& structure, EdgeRef edge);

}  // namespace boxplus::viewer
