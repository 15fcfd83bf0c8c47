// SPDX-License-Identifier: BSD-3-Clause
// The active edges in parts that different threads may work on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "g2o/core/jacobian_workspace.h"
#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// Whether all vertices are there: clients may take them away by setVertex() or vertices() at any time.
inline bool is_complete(const OptimizableGraph::Edge& edge) {
  for (const HyperGraph::Vertex* v : edge.vertices()) {
    if (v == nullptr) return false;
  }
  return true;
}

/// Edges of one part share no vertex that may move with those of another: neither blocks of H nor of b. Edges
/// between parts, and those of types that nothing is known of, are left for one thread. How many parts there
/// are, and so the order in which blocks are added up, does not depend on the number of threads.
class EdgeParts {
 public:
  using Edge = OptimizableGraph::Edge;
  using Edges = OptimizableGraph::EdgeContainer;

  /// Parts the edges anew, vertices known by their Hessian indices.
  void part(const Edges& edges, int vertices);
  /// Whether they are those, and what is known of types is what it was.
  bool is_of(const Edges& edges) const;

  /// f(edge) for each edge once, in any order.
  void for_each(boxplus::FunctionRef<void(Edge&)> f) const;
  /// f(edge, workspace), edges of one part after each other, and those left after all parts. Edges whose
  /// robust kernel is the client's are left as well.
  void for_each_by_parts(JacobianWorkspace& workspace,
                         boxplus::FunctionRef<void(Edge&, JacobianWorkspace&)> f);

 private:
  static constexpr int kParts = 8;

  Edges edges_, left_;
  std::uint64_t known_types_ = 0;
  std::array<Edges, kParts> parts_, with_unknown_kernels_;
  std::array<JacobianWorkspace, kParts> workspaces_;
};

}  // namespace internal
}  // namespace g2o
