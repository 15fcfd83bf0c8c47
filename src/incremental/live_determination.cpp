// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a LiveProblem that are left out with their edges, because these do not determine them yet.
#include <algorithm>
#include <utility>

#include "base/symmetric_eigen.h"
#include "incremental/live_problem.h"

namespace boxplus {

using Index = IncrementalFactor::Index;

// ---- Leaving out ----

/// Whether the edges of a block have too few rows to determine it. If an edge is about no other block, the
/// directions that are missing can be held (hold()).
bool LiveProblem::has_few_rows(Index block) const {
  const VertexRef vertex = vertex_of_[block];
  if (vertices_[vertex.pool][vertex.slot].block != block || factor_.terms_of(block).empty()) return false;
  int missing = static_cast<int>(factor_.dim(block) - factor_.held_scalars(block).size());
  for (const Index term : factor_.terms_of(block)) {
    const EdgeName name = edge_of_[term];
    missing -= graph_.edge_pools()[name.pool]->shape(name.slot).rows;
    if (missing <= 0 || factor_.blocks_of(term).size() == 1) return false;
  }
  return true;
}

bool LiveProblem::leave_out_with_few_rows() {
  std::vector<Index> blocks = std::exchange(few_rows_, {});
  std::erase_if(blocks, [&](Index block) { return !has_few_rows(block); });
  leave_out(blocks);
  return !blocks.empty();
}

bool LiveProblem::leave_out_undetermined(Index lost) {
  std::vector<Index> blocks;
  if (!is_determined_alone(lost)) {
    blocks.push_back(lost);
  } else {
    for (const Index term : factor_.terms_of(lost)) {
      for (const Index other : factor_.blocks_of(term)) {
        if (!is_determined_alone(other)) blocks.push_back(other);
      }
    }
  }
  leave_out(blocks);
  return !blocks.empty();
}

/// Leaves blocks out with their edges, and those that have no other edges.
void LiveProblem::leave_out(std::span<const Index> blocks) {
  std::vector<Index> others(blocks.begin(), blocks.end());
  for (std::size_t k = 0; k < others.size(); ++k) {
    const VertexRef vertex = vertex_of_[others[k]];
    VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
    if (entry.is_left_out || (k >= blocks.size() && !factor_.terms_of(others[k]).empty())) continue;
    entry.is_left_out = true;
    left_out_.push_back(vertex);
    while (!factor_.terms_of(others[k]).empty()) {
      const Index term = factor_.terms_of(others[k]).front();
      const auto members = factor_.blocks_of(term);
      others.insert(others.end(), members.begin(), members.end());
      remove_term(edge_of_[term]);
    }
  }
  remove_unused_blocks();
}

std::size_t LiveProblem::remove_stranded() {
  std::size_t count = 0;
  std::erase_if(left_out_, [&](VertexRef vertex) {
    if (!graph_.contains(vertex)) return true;
    if (!graph_.edges(vertex).empty()) return false;
    graph_.remove(vertex);
    ++count;
    return true;
  });
  return count;
}

/// Whether the edges of a block determine it if all other blocks are known.
bool LiveProblem::is_determined_alone(Index block) const {
  const auto dim = static_cast<Eigen::Index>(factor_.dim(block));
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(dim, dim);
  for (const Index term : factor_.terms_of(block)) {
    const auto blocks = factor_.blocks_of(term);
    const auto k = static_cast<std::size_t>(std::find(blocks.begin(), blocks.end(), block) - blocks.begin());
    const double* const values =
        factor_.values_of(term).data() + factor_.block_of(term, k, k) - factor_.gradient_of(term, 0);
    sum += Eigen::Map<const Eigen::MatrixXd>(values, dim, dim);
  }
  for (const int held : factor_.held_scalars(block)) sum(held, held) += 1;
  const Eigen::VectorXd scale = sum.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0)) return false;
  constexpr double kSingular = 1e-10;
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * sum * scale.cwiseInverse().asDiagonal();
  return symmetric_eigen(scaled).values.minCoeff() > kSingular;
}

// ---- Taking in ----

/// Lets vertices that were left out take part again if they or their edges have changed.
void LiveProblem::take_in(const detail::ChangeLog& log) {
  std::vector<VertexRef> vertices;
  bool is_any_gone = false;
  for (const EdgeRef& edge : log.edges) {
    if (graph_.edge_pools()[edge.pool]->alive(edge.slot)) {
      append_left_out({edge.pool, edge.slot}, vertices);
    } else {
      is_any_gone = true;
    }
  }
  for (const VertexRef& vertex : log.vertices) {
    vertices.push_back({vertex.pool, vertex.slot, vertices_[vertex.pool][vertex.slot].generation});
    is_any_gone = is_any_gone || !graph_.contains(vertex);
  }
  take_in(std::move(vertices));
  if (!is_any_gone) return;
  std::erase_if(left_out_, [&](VertexRef vertex) {
    if (graph_.contains(vertex) && !graph_.edges(vertex).empty()) return false;
    if (graph_.contains(vertex)) vertices_[vertex.pool][vertex.slot].is_left_out = false;
    return true;
  });
}

/// Lets those of the vertices that were left out take part again, with all of their edges, and then the other
/// vertices of these.
void LiveProblem::take_in(std::vector<VertexRef> vertices) {
  while (!vertices.empty()) {
    const VertexRef vertex = vertices.back();
    vertices.pop_back();
    VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
    if (!entry.is_left_out) continue;
    entry.is_left_out = false;
    std::erase(left_out_, vertex);
    if (!graph_.contains(vertex)) continue;
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      again_.push_back(edge);
      append_left_out({edge.pool, edge.slot}, vertices);
    }
  }
}

/// Appends the vertices of an edge that are left out.
void LiveProblem::append_left_out(EdgeName edge, std::vector<VertexRef>& out) const {
  const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
  const auto slots = pool.vertex_slots(edge.slot);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
    const VertexEntry& entry = vertices_[p][slots[i]];
    if (entry.is_left_out) out.push_back({p, slots[i], entry.generation});
  }
}

bool LiveProblem::is_left_out(EdgeName edge) const {
  if (left_out_.empty()) return false;
  std::vector<VertexRef> vertices;
  append_left_out(edge, vertices);
  return !vertices.empty();
}

}  // namespace boxplus
