// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/edge_kind.h"
#include "g2o/core/optimizable_graph.h"
#include "kernels/kernel_table.h"

namespace g2o {
namespace internal {

/// The Hessian index of a vertex, or −1 if the vertex is fixed or missing.
inline int hessian_index(const HyperGraph::Vertex* v) {
  return v == nullptr ? -1 : static_cast<const OptimizableGraph::Vertex*>(v)->hessianIndex();
}

/// Bit n says whether vertex n of the edge is in H.
inline std::uint32_t positions_in_hessian(const OptimizableGraph::Edge& edge) {
  std::uint32_t mask = 0;
  for (std::size_t n = 0; n < edge.vertices().size(); ++n)
    mask |= (hessian_index(edge.vertex(n)) >= 0 ? 1u : 0u) << n;
  return mask;
}

/// A kernel of the engine that adds the edges of a batch to H, and the vertices in its order.
class EdgeAdder {
 public:
  /// Finds the kernel for edges of a kind whose vertices in H are given by positions_in_hessian(). Returns
  /// nothing if the engine has no such kernel.
  static std::optional<EdgeAdder> find(const EdgeKind& kind, std::uint32_t mask);

  std::vector<int> positions;  ///< of the vertices that are not fixed
  boxplus::dense::AddEdges in_lanes = nullptr;
  boxplus::dense::AddUnaryEdges unary = nullptr;

 private:
  bool choose(const EdgeKind& kind);
};

/// Edges of one kind with the same positions in H.
struct EdgeBatch {
  const EdgeKind* kind = nullptr;
  std::uint32_t mask = 0;
  EdgeAdder adder;
  OptimizableGraph::EdgeContainer edges;
  std::vector<int> vertices;           ///< the Hessian indices of the vertices in H of each edge
  int columns = 0;                     ///< of the Jacobians of these vertices
  std::vector<std::uint32_t> targets;  ///< of each edge, as in EdgeLanes and UnaryEdges

  /// Whether edge k still has the vertices that it had when it was taken, and the same ones are fixed.
  bool is_current(std::size_t k) const {
    const OptimizableGraph::Edge& edge = *edges[k];
    const int* index = vertices.data() + k * adder.positions.size();
    if (positions_in_hessian(edge) != mask) return false;
    for (const int n : adder.positions) {
      if (hessian_index(edge.vertex(static_cast<std::size_t>(n))) != *index++) return false;
    }
    return true;
  }
  std::size_t targets_per_edge() const {
    const std::size_t n = adder.positions.size();
    return n + n * (n + 1) / 2;
  }
};

}  // namespace internal
}  // namespace g2o
