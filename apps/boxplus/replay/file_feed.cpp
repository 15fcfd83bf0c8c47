// SPDX-License-Identifier: BSD-3-Clause
#include "replay/file_feed.h"

#include <algorithm>

namespace boxplus::app {

FileFeed::FileFeed(Graph& graph)
    : graph_(graph), vertices_(graph.all_vertices()), edges_(vertices_.size()), placement_(graph) {
  std::vector<std::vector<std::size_t>> step_of(graph.vertex_pools().size());
  for (std::size_t p = 0; p < step_of.size(); ++p) step_of[p].resize(graph.vertex_pools()[p]->slots(), 0);
  for (std::size_t k = 0; k < vertices_.size(); ++k) step_of[vertices_[k].pool][vertices_[k].slot] = k;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (graph.level(edge) != 0) continue;
    std::size_t last = 0;  // parameters are there from the beginning
    for (const VertexRef& vertex : graph.vertices(edge))
      last = std::max(last, step_of[vertex.pool][vertex.slot]);
    if (!edges_.empty()) edges_[last].push_back(edge);
    graph.set_level(edge, 1);
  }
  for (const VertexRef& vertex : vertices_) {
    if (!graph.is_fixed(vertex)) placement_.expect(vertex);
  }
}

void FileFeed::add(std::size_t step) {
  for (const EdgeRef& edge : edges_[step]) {
    graph_.set_level(edge, 0);
    placement_.place_by(edge);
  }
  placement_.keep(vertices_[step]);
}

}  // namespace boxplus::app
