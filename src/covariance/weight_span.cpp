// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/weight_span.h"

#include <fmt/format.h>

#include <cmath>

namespace boxplus {
namespace {

/// "Prior<SE3>, vertex 1"
std::string name(const Graph& graph, const EdgeRef& edge) {
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  std::string text(graph.edge_pools()[edge.pool]->type_name());
  text += vertices.size() == 1 ? ", vertex" : ", vertices";
  for (const VertexRef& vertex : vertices) text += " " + std::to_string(graph.id(vertex));
  return text;
}

}  // namespace

double WeightSpan::digits() const {
  return least > 0 ? std::log10(most) - std::log10(least) : 0;
}

WeightSpan weight_span(const Graph& graph, const Plan& plan) {
  WeightSpan span;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (!pool.enabled(edge)) continue;
      const int rows = pool.shape(edge).rows;
      const detail::InformationView omega = pool.information(edge, rows);
      const EdgeRef ref{list.pool, edge, pool.generation(edge)};
      for (int i = 0; i < rows; ++i) {
        const double weight = omega(i, i);
        if (!(weight > 0)) continue;
        if (span.least == 0 || weight < span.least) span.least = weight, span.lightest = ref;
        if (weight > span.most) span.most = weight, span.heaviest = ref;
      }
    }
  }
  return span;
}

std::string to_string(const WeightSpan& span, const Graph& graph) {
  return fmt::format("the weights span {:.1f} digits, from {:.3g} ({}) to {:.3g} ({})", span.digits(),
                     span.least, name(graph, span.lightest), span.most, name(graph, span.heaviest));
}

}  // namespace boxplus
