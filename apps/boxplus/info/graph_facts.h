// SPDX-License-Identifier: BSD-3-Clause
// The facts about a graph that `boxplus info` prints.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "optimize/edge_roles.h"

namespace boxplus::app {

struct Degrees {
  std::size_t min = 0, max = 0;
  double mean = 0;
};

struct VertexTypeFacts {
  std::string tag;  ///< the tag in the file, or the name of the type if it has no tag
  VertexRole role = VertexRole::kOther;
  bool parameter = false;
  std::size_t count = 0, fixed = 0, unknowns = 0;
  Degrees degrees;  ///< edges per vertex
};

struct EdgeFacts {
  EdgeRef edge;
  std::string tag;
  std::vector<Id> vertices;  ///< without parameters
  double chi2 = 0;
  std::int64_t line = 0;  ///< of the file; 0: unknown
};

struct EdgeTypeFacts {
  std::string tag;
  std::size_t count = 0, rows = 0;  ///< rows of error, summed over all edges
  double chi2 = 0;
  EdgeFacts worst;
};

/// A set of vertices connected by edges; parameters do not connect.
struct ComponentFacts {
  Id first = 0;  ///< lowest id
  std::size_t vertices = 0, edges = 0;
  std::vector<Id> fixed, held;  ///< fixed by the file; held by optimize, because nothing else holds them
  std::size_t priors = 0;
  std::string_view free;  ///< motions that change no error, beyond those that optimize holds; may be empty
};

struct GraphFacts {
  std::vector<VertexTypeFacts> vertex_types;
  std::vector<EdgeTypeFacts> edge_types;
  std::array<std::size_t, kEdgeRoles> roles{};  ///< edges by EdgeRole
  std::vector<ComponentFacts> components;       ///< largest first; without single vertices that have no edges
  std::vector<Id> isolated;                     ///< vertices without edges
  std::vector<EdgeFacts> worst;                 ///< largest chi2 first
  std::size_t vertices = 0, parameters = 0, edges = 0, unknowns = 0, rows = 0;
  double chi2 = 0;
  int dimension = 0;               ///< of the world; 0: no vertex has a position
  std::array<double, 3> extent{};  ///< of all positions, meters
};

/// `edge_lines` is the result of find_edge_lines(); `worst` is the number of edges to list.
GraphFacts find_facts(const GraphFile& file, const std::vector<std::int64_t>& edge_lines, std::size_t worst);

}  // namespace boxplus::app
