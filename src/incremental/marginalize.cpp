// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/marginalize.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"
#include "incremental/dense_marginal.h"

namespace boxplus {
namespace {

void check(const Graph& graph, std::span<const VertexRef> vertices) {
  std::vector<VertexRef> seen;
  for (const VertexRef& vertex : vertices) {
    const auto complain = [&](const char* what) {
      throw InvalidArgument("marginalize: vertex " + std::to_string(graph.id(vertex)) + what);
    };
    if (graph.is_fixed(vertex)) complain(" is fixed");
    if (!graph.bounds(vertex).empty()) complain(" has bounds");
    if (std::find(seen.begin(), seen.end(), vertex) != seen.end()) complain(" appears twice");
    seen.push_back(vertex);
    for (const EdgeRef& edge : graph.edges(vertex)) {
      if (graph.edge_pools()[edge.pool]->shift(edge.slot) != nullptr) complain(" has a constraint");
    }
  }
}

bool takes_part(const Graph& graph, EdgeRef edge) {
  return graph.is_enabled(edge) && graph.level(edge) == 0;
}

/// Adds an edge to the model, at the current estimates.
void add_edge(const Graph& graph, EdgeRef edge, DenseModel& model) {
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  std::vector<Eigen::MatrixXd> blocks = graph.jacobian(edge);
  const std::vector<double> values = graph.error(edge);
  const Eigen::Map<const Eigen::VectorXd> error(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::MatrixXd omega = graph.weight(edge) * graph.information(edge).matrix();
  if (!error.allFinite() || !omega.allFinite() ||
      !std::all_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.allFinite(); }))
    throw InvalidArgument("marginalize: the error or the Jacobian of an edge of vertex " +
                          std::to_string(graph.id(vertices[0])) + " is not finite");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (const int fixed : graph.fixed_directions(vertices[i])) blocks[i].col(fixed).setZero();
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Index a = model.find(vertices[i]);
    if (a < 0) continue;  // fixed
    const Eigen::MatrixXd weighted = blocks[i].transpose() * omega;
    const Eigen::Index row = model.offset[a];
    model.b.segment(row, weighted.rows()) += weighted * error;
    for (std::size_t j = 0; j < vertices.size(); ++j) {
      const Eigen::Index c = model.find(vertices[j]);
      if (c < 0) continue;
      model.H.block(row, model.offset[c], weighted.rows(), blocks[j].cols()) += weighted * blocks[j];
    }
  }
}

}  // namespace

std::optional<EdgeRef> marginalize(Graph& graph, std::span<const VertexRef> vertices) {
  check(graph, vertices);
  std::vector<EdgeRef> edges;
  std::vector<VertexRef> neighbors;
  for (const VertexRef& vertex : vertices) {
    for (const EdgeRef& edge : graph.edges(vertex)) {
      if (takes_part(graph, edge)) edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const EdgeRef& edge : edges) {
    for (const VertexRef& vertex : graph.vertices(edge)) {
      const bool stays = std::find(vertices.begin(), vertices.end(), vertex) == vertices.end();
      if (stays && !graph.is_fixed(vertex)) neighbors.push_back(vertex);
    }
  }
  DenseModel model;
  model.set_vertices(graph, vertices, std::move(neighbors));
  for (const EdgeRef& edge : edges) add_edge(graph, edge, model);
  const DenseModel prior = eliminated(model, vertices.size());
  std::optional<EdgeRef> result;
  if (!prior.vertices.empty()) result = add_marginal_prior(graph, prior, graph.vertex_pools());
  for (const VertexRef& vertex : vertices) graph.remove(vertex);
  return result;
}

}  // namespace boxplus
