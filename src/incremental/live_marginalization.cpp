// SPDX-License-Identifier: BSD-3-Clause
// The marginalization of vertices of a LiveProblem, from the terms that it has.
#include <algorithm>
#include <iterator>

#include "incremental/dense_marginal.h"
#include "incremental/live_problem.h"
#include "incremental/marginal_pool.h"

namespace boxplus {

using Index = IncrementalFactor::Index;

std::vector<VertexRef> LiveProblem::followers(std::span<const VertexRef> leaving,
                                              detail::FunctionRef<bool(VertexRef)> stays) const {
  std::vector<VertexRef> result;
  const auto leaves = [&](Index b) {
    return std::find(leaving.begin(), leaving.end(), vertex_of_[b]) != leaving.end();
  };
  const auto for_each_neighbor = [&](Index b, auto&& f) {
    for (const Index term : factor_.terms_of(b)) {
      if (dynamic_cast<const MarginalPool*>(graph_.edge_pools()[edge_of_[term].pool].get()) != nullptr)
        continue;
      for (const Index other : factor_.blocks_of(term)) {
        if (other != b) f(other);
      }
    }
  };
  // The neighbors of a vertex, which may be held and then has no block.
  const auto for_each_neighbor_of = [&](VertexRef vertex, auto&& f) {
    if (block(vertex) != kNone) return for_each_neighbor(block(vertex), f);
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      for (const VertexRef& other : graph_.vertices(edge)) {
        if (other != vertex && block(other) != kNone) f(block(other));
      }
    }
  };
  const auto look_at = [&](Index b) {
    if (leaves(b) || stays(vertex_of_[b])) return;
    bool is_needed = false;
    for_each_neighbor(b, [&](Index other) { is_needed = is_needed || !leaves(other); });
    if (!is_needed) result.push_back(vertex_of_[b]);
  };
  for (const VertexRef& vertex : leaving) {
    for_each_neighbor_of(vertex, look_at);
    if (block(vertex) == kNone) continue;
    for (const Index term : factor_.terms_of(block(vertex))) {
      for (const Index other : factor_.blocks_of(term)) look_at(other);  // also those that only a prior joins
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void LiveProblem::marginalize(std::span<const VertexRef> vertices) {
  std::vector<Index> terms;
  std::vector<VertexRef> others;
  for (const VertexRef& vertex : vertices) {
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      const EdgeEntry& entry = edges_[edge.pool][edge.slot];
      if (entry.term != kNone && entry.generation == edge.generation) terms.push_back(entry.term);
    }
  }
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  for (const Index term : terms) {
    for (const Index b : factor_.blocks_of(term)) {
      if (std::find(vertices.begin(), vertices.end(), vertex_of_[b]) == vertices.end())
        others.push_back(vertex_of_[b]);
    }
  }
  std::vector<VertexRef> gone;  // without those that are held
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(gone),
               [&](VertexRef vertex) { return block(vertex) != kNone; });
  DenseModel model;
  model.set_vertices(graph_, gone, std::move(others));
  const double* const values = factor_.values();
  for (const Index term : terms) {
    const auto blocks = factor_.blocks_of(term);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Eigen::Index rows = factor_.dim(blocks[i]), row = model.first_of(vertex_of_[blocks[i]]);
      model.b.segment(row, rows) +=
          Eigen::Map<const Eigen::VectorXd>(values + factor_.gradient_of(term, i), rows);
      for (std::size_t j = 0; j <= i; ++j) {
        const Eigen::Index columns = factor_.dim(blocks[j]), column = model.first_of(vertex_of_[blocks[j]]);
        const Eigen::Map<const Eigen::MatrixXd> part(values + factor_.block_of(term, i, j), rows, columns);
        model.H.block(row, column, rows, columns) += part;
        if (i != j) model.H.block(column, row, columns, rows) += part.transpose();
      }
    }
  }
  const DenseModel prior = eliminated(model, gone.size());
  if (!prior.vertices.empty()) add_marginal_prior(graph_, prior, points_);
  for (const VertexRef& vertex : prior.vertices) vertices_[vertex.pool][vertex.slot].is_pinned = true;
  for (const VertexRef& vertex : vertices) graph_.remove(vertex);
}

}  // namespace boxplus
