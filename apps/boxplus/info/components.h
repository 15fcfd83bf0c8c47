// SPDX-License-Identifier: BSD-3-Clause
// Finds the connected components of a graph, and the vertices and edges that hold each component in place.
#pragma once

#include <string_view>
#include <vector>

#include "graph/graph_view.h"
#include "plan/plan.h"

namespace boxplus::app {

/// A set of vertices that edges connect. Parameters do not connect vertices.
struct ComponentFacts {
  Id first = 0;  ///< the lowest id of its vertices
  std::size_t vertices = 0, edges = 0;
  std::vector<Id> fixed;  ///< the vertices that the file fixes
  std::vector<Id> held;   ///< the vertices that optimize holds, because nothing else holds the component
  std::size_t priors = 0;
  /// The motions that change no error even while the vertices in `held` are fixed; empty if there are none.
  std::string_view free;
};

struct Components {
  std::vector<ComponentFacts> with_edges;  ///< the largest first
  std::vector<Id> isolated;                ///< the ids of the vertices without edges
};

/// `plan` is the plan of an optimization with default options. Takes O(n log n) time.
Components find_components(const Graph& graph, const Plan& plan, const EdgeRoles& role_of_edge);

}  // namespace boxplus::app
