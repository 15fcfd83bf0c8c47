// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph that grows and changes, for robots that need the optimum after each step.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "boxplus/gauge/gauge.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

/// A distance in the tangent of a vertex: of its lengths in meters, of its angles in radians, and of all other
/// numbers. The tangent of a pose has lengths and angles; that of a point has lengths.
struct TangentDistance {
  double length = 0, angle = 0, other = 0;
};

struct SmootherOptions {
  /// A vertex is linearized anew when its estimate is farther than this from its linearization point.
  TangentDistance relinearize{0.1, 0.03, 0.03};
  /// Smaller changes of a vertex are not passed on to its neighbors.
  TangentDistance noticeable{1e-3, 1e-3, 1e-3};
  /// An update relinearizes until no vertex has to be linearized anew, or until it has done so this often.
  int max_iterations = 20;
  /// An update begins no further iteration after this time, and the next update goes on. At least one
  /// iteration is made.
  double time_limit_s = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* stop = nullptr;  ///< stops when this flag becomes true; may be null
  bool numeric_jacobians = false;           ///< differentiate every edge numerically
};

/// What an update did.
struct SmootherReport {
  enum class Reason : std::uint8_t {
    kConverged,       ///< no vertex is to be linearized anew
    kMaxIterations,   ///< the next update goes on
    kTimeLimit,       ///< the next update goes on
    kStopFlag,        ///< the next update goes on
    kNotDetermined,   ///< the edges do not determine the vertex `vertex`; the estimates are unchanged
  };
  Reason reason = Reason::kConverged;
  std::string message;  ///< names the vertex if the reason is kNotDetermined; empty if all is well
  int iterations = 0;
  std::uint32_t vertices = 0;      ///< vertices that can move
  std::uint32_t edges = 0;         ///< edges that take part
  std::uint32_t relinearized = 0;  ///< edges that were linearized in this update
  std::uint32_t ordered = 0;       ///< vertices that were ordered anew
  std::uint32_t refactored = 0;    ///< fronts of the factor that were computed
  double refactored_share = 0;     ///< the share of the unknowns in these fronts
  std::uint32_t moved = 0;         ///< estimates that were computed
  double flops = 0;                ///< the operations of the factorizations
  bool started_over = false;       ///< the steps diverged, and optimize() ran over the whole graph
  double time_s = 0;
  std::vector<detail::GaugeVertex> held;  ///< vertices that are held because nothing fixes their components
  bool converged() const { return reason == Reason::kConverged; }
};

/// Keeps a graph at its optimum while it changes. After any edits of the graph, update() brings its estimates
/// to the optimum. Its time depends on what the edits change, not on the size of the graph.
///
///     Smoother smoother(graph);
///     for (;;) {
///       graph.add_vertex(…); graph.add_edge(…);   // any edits
///       smoother.update();
///     }
///
/// It keeps the linearization of every edge, and the Cholesky factor of H as a tree. New edges change the part
/// of the tree between their vertices and its root; only this part is ordered and factorized anew (Kaess et
/// al., "iSAM2: Incremental smoothing and mapping using the Bayes tree", IJRR 2012). A vertex that moves away
/// from its linearization point is linearized anew, until none does.
///
/// All edges of level 0 take part, and all vertices may move that are not fixed. A graph has at most one
/// Smoother. If other programs change estimates, for example optimize(), the next update reads the whole
/// graph again.
class Smoother {
 public:
  /// Keeps a reference to `graph`. Throws InvalidArgument if the graph has a Smoother already.
  explicit Smoother(Graph& graph, SmootherOptions options = {});
  ~Smoother();
  Smoother(Smoother&&) noexcept;
  Smoother& operator=(Smoother&&) noexcept;

  /// Throws InvalidArgument if the graph is gone, and what error functions throw. Graph and smoother are then
  /// as before, and the next update begins anew.
  SmootherReport update();
  /// Like update(), but computes all vertices, and linearizes anew until the estimates are at the optimum to
  /// the last digits, as optimize() does. Takes a few iterations over the whole graph.
  SmootherReport finish();
  const SmootherOptions& options() const;
  void set_options(const SmootherOptions& options);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxplus
