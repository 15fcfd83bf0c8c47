// SPDX-License-Identifier: BSD-3-Clause
// The active edges, divided into parts that different threads can process at the same time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "engine/edge_batches.h"
#include "g2o/core/jacobian_workspace.h"
#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// Whether an edge has all of its vertices. Clients may remove vertices from an edge with setVertex() or
/// vertices() at any time.
inline bool is_complete(const OptimizableGraph::Edge& edge) {
  for (const HyperGraph::Vertex* v : edge.vertices()) {
    if (v == nullptr) return false;
  }
  return true;
}

/// Edges in different parts have no vertex in common except fixed vertices. Therefore, they add to different
/// blocks of H and b. One thread processes the remaining edges: edges with vertices in different parts, and
/// edges of types that are not known to be thread-safe. The number of parts is constant, so the order of
/// additions does not depend on the number of threads.
class EdgeParts {
 public:
  using Edge = OptimizableGraph::Edge;
  using Edges = OptimizableGraph::EdgeContainer;

  /// Divides the edges into parts. `vertices` is the number of Hessian indices.
  void part(const Edges& edges, int vertices);
  /// Whether part() was called for these edges, and the set of thread-safe types has not changed since.
  bool is_of(const Edges& edges) const;

  EdgeBatches& batches() { return batches_; }

  /// Calls computeError() of each edge that has all its vertices, in any order. If `with_batches` is false,
  /// leaves out the edges in batches(). Returns whether an edge lacks a vertex.
  bool compute_errors(bool with_batches);
  /// Does the same only for the edges in batches().
  bool compute_errors_of_batches();
  /// Calls EdgeBatches::linearize(). Returns whether an edge lacks a vertex.
  bool linearize_batches(double* values, double* gradient, bool with_errors);
  /// The sum of ρ(eᵀΩe) over all edges, after compute_errors(true) or linearize_batches().
  double robust_chi2_of_pass() const;
  /// Calls f(edge, workspace) for the edges that linearize_batches() did not add to H, or for all edges in
  /// batches() if it was not called.
  void for_each_of_batches(JacobianWorkspace& workspace,
                           boxplus::detail::FunctionRef<void(Edge&, JacobianWorkspace&)> f,
                           bool were_linearized) const;
  /// Calls f(edge, workspace) for the edges of each part in order, and for the remaining edges after all
  /// parts. Edges with a robust kernel that is not known to be thread-safe also come after all parts. Leaves
  /// out the edges in batches().
  void for_each_by_parts(JacobianWorkspace& workspace,
                         boxplus::detail::FunctionRef<void(Edge&, JacobianWorkspace&)> f);

 private:
  static constexpr int kParts = 8;

  Edges edges_, others_, left_;  // all edges; those outside of batches; those of `others_` in no part
  EdgeBatches batches_;
  BatchPass pass_;  // the last pass over the batches
  std::uint64_t known_types_ = 0;
  std::array<Edges, kParts> parts_, with_unknown_kernels_;
  std::array<JacobianWorkspace, kParts> workspaces_;
};

}  // namespace internal
}  // namespace g2o
