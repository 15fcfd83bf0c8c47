// SPDX-License-Identifier: BSD-3-Clause
// The division of the edges in batches into parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/edge_batch.h"

namespace g2o {
namespace internal {

/// The edges that are evaluated in batches, before they are divided into parts.
class TakenEdges {
 public:
  struct Item {
    OptimizableGraph::Edge* edge;
    std::uint32_t batch, begin;  ///< its Hessian indices begin here in `indices`
  };

  /// `vertices` is the number of Hessian indices.
  explicit TakenEdges(int vertices) : is_marginalized(static_cast<std::size_t>(vertices)) {}

  /// Returns false, without taking the edge, if it cannot be evaluated in a batch.
  bool take(OptimizableGraph::Edge& edge, const EdgeKind& kind);

  const int* begin(const Item& item) const { return indices.data() + item.begin; }
  const int* end(const Item& item) const { return begin(item) + batches[item.batch].adder.positions.size(); }

  std::vector<EdgeBatch> batches;  ///< without edges
  std::vector<Item> items;
  std::vector<int> indices;
  std::vector<char> is_marginalized;  ///< by Hessian index

 private:
  std::optional<std::uint32_t> batch_of(const OptimizableGraph::Edge& edge, const EdgeKind& kind);
};

/// Divides edges into parts. Vertices are numbered in the order in which edges first use them, and each part
/// owns the vertices of a range of numbers. The ranges have similar numbers of edges.
class BatchDivision {
 public:
  static constexpr int kParts = 8;

  /// There must be at least one edge.
  explicit BatchDivision(const TakenEdges& taken);

  int part_of_vertex(int h) const { return part_[number(h)]; }
  int part_of(const TakenEdges::Item& item) const { return part_of_vertex(owner(item)); }

 private:
  int number(int h) const { return number_[h]; }
  int owner(const TakenEdges::Item& item) const;

  const TakenEdges& taken_;
  std::vector<int> number_;  // of each vertex, by Hessian index
  std::vector<int> part_;    // of each vertex, by number
};

}  // namespace internal
}  // namespace g2o
