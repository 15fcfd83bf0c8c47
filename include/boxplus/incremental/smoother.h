// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph that grows and changes, for robots that need the optimum after each step.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/incremental/smoother_options.h"

namespace boxplus {

/// Keeps a graph at its optimum while it changes. After any edits of the graph, update() brings its estimates
/// to the optimum. Its time depends on what the edits change, not on the size of the graph.
///
///     Smoother smoother(graph);
///     for (;;) {
///       graph.add_vertex(…); graph.add_edge(…);   // any edits
///       smoother.update();
///     }
///
/// It keeps the linearization of every edge, and the Cholesky factor of H as a tree. New edges change the
/// part of the tree between their vertices and its root; only this part is ordered and factorized anew (Kaess
/// et al., "iSAM2: Incremental smoothing and mapping using the Bayes tree", IJRR 2012). A vertex that moves
/// away from its linearization point is linearized anew, until none does.
///
/// All enabled edges of level 0 take part, and all vertices may move that are not fixed. A graph has at most
/// one Smoother. If other programs change estimates, for example optimize(), the next update reads the whole
/// graph again.
class Smoother {
 public:
  /// Keeps a reference to `graph`. Throws InvalidArgument if the graph has a Smoother already.
  explicit Smoother(Graph& graph, const SmootherOptions& options = {});
  ~Smoother();
  Smoother(Smoother&&) noexcept;
  Smoother& operator=(Smoother&&) noexcept;

  /// Throws InvalidArgument if the graph is gone, and what error functions throw. Graph and smoother are then
  /// as before, and the next update begins anew.
  SmootherReport update();
  /// Like update(), but computes all vertices, and linearizes anew until the estimates are at the optimum to
  /// the last digits, as optimize() does. Takes a few iterations over the whole graph.
  SmootherReport finish();
  /// Sets the time of a vertex, for SmootherOptions::lag. Without a time, a pose has the time of the newest
  /// vertex with a time when its first update begins.
  void set_time(VertexRef vertex, double seconds);
  /// The joint covariance of a few vertices, as of the last update: the part of H⁻¹ that belongs to their
  /// tangents, in the given order. It comes from the live factor, without a new factorization; for the newest
  /// vertices it takes microseconds. Fixed and held vertices have zeros. Throws InvalidArgument if a vertex
  /// takes no part, or if the last update failed.
  Eigen::MatrixXd covariance(std::span<const VertexRef> vertices) const;
  Eigen::MatrixXd covariance(std::initializer_list<VertexRef> vertices) const {
    return covariance(std::span(vertices.begin(), vertices.size()));
  }
  /// What an edge would cost and change, without any effect. Add the edge and disable it
  /// (Graph::set_enabled), look, and then enable or remove it. Its vertices must have other edges. The kernel
  /// does not count. Throws InvalidArgument as covariance() does, and if the edge joins a part of the graph
  /// that nothing anchors with something else: it may move this part, and then costs nothing.
  EdgePreview preview(EdgeRef edge) const;
  /// All loop closures that are set aside.
  std::vector<EdgeRef> set_aside() const;
  const SmootherOptions& options() const;
  void set_options(const SmootherOptions& options);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxplus
