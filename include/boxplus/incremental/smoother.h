// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph that grows and changes, for robots that need the optimum after each step.
#pragma once

#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"
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

  /// Sets false loop closures aside: edges between vertices that were there before, whose predicted cost
  /// (EdgePreview::chi2_increase) is above the limit that a true one exceeds with the probability
  /// `false_alarm`. As the graph grows, and in finish(), find_outliers() judges all closures of a pose graph
  /// together; it may take some back and set others aside. The report names both. Not together with a lag.
  bool sets_outliers_aside = false;
  double false_alarm = 2e-4;

  /// A fixed lag: after each update, the oldest vertices are marginalized, so that at most `lag` of the
  /// vertices with times remain, and none that is more than `lag_s` older than the newest one. All poses have
  /// times; Smoother::set_time() sets those of any vertices. Every other vertex, such as a landmark or a
  /// velocity, leaves with the last vertex that shares an edge with it. Time and memory per update are then
  /// constant. Vertices in the prior keep their linearization points, so that the estimates are consistent.
  std::size_t lag = std::numeric_limits<std::size_t>::max();
  double lag_s = std::numeric_limits<double>::infinity();
};

/// What an update did.
struct SmootherReport {
  enum class Reason : std::uint8_t {
    kConverged,       ///< no vertex is to be linearized anew
    kMaxIterations,   ///< the next update goes on
    kTimeLimit,       ///< the next update goes on
    kStopFlag,        ///< the next update goes on
    kNonFinite,       ///< an error or a Jacobian is not finite; the estimates are unchanged
    kNotDetermined,   ///< the edges do not determine the vertex `vertex`; the estimates are unchanged
  };
  Reason reason = Reason::kConverged;
  std::string message;  ///< names the vertices of a failure; otherwise empty
  int iterations = 0;
  std::uint32_t vertices = 0;      ///< vertices that can move
  std::uint32_t edges = 0;         ///< edges that take part
  std::uint32_t relinearized = 0;  ///< edges that were linearized in this update
  std::uint32_t ordered = 0;       ///< vertices that were ordered anew
  std::uint32_t refactored = 0;    ///< fronts of the factor that were computed
  double refactored_share = 0;     ///< the share of the unknowns in these fronts
  /// Loop closures whose verdicts have changed (SmootherOptions::sets_outliers_aside).
  std::vector<EdgeRef> set_aside, taken_back;
  std::uint32_t marginalized = 0;  ///< vertices that left the lag
  std::uint32_t moved = 0;         ///< estimates that were computed
  double flops = 0;                ///< the operations of the factorizations
  bool started_over = false;       ///< the steps diverged, and optimize() ran over the whole graph
  double time_s = 0;
  std::vector<detail::GaugeVertex> held;  ///< vertices that are held because nothing fixes their components
  bool converged() const { return reason == Reason::kConverged; }
};

std::string_view to_string(SmootherReport::Reason reason);

/// What an edge would cost and change, predicted from the linear model.
struct EdgePreview {
  double chi2 = 0;           ///< eᵀΩe at the current estimates
  double chi2_increase = 0;  ///< of the minimum of chi2: eᵀ(Ω⁻¹ + JΣJᵀ)⁻¹e, the squared Mahalanobis distance
  int rows = 0;              ///< if the edge is right, chi2_increase has the χ² distribution of so many rows
  std::vector<Eigen::VectorXd> steps;  ///< by how much each of its vertices would move
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
  /// What an edge would cost and change, without any effect. Add the edge and disable it (Graph::set_enabled),
  /// look, and then enable or remove it. Its vertices must have other edges. The kernel does not count. Throws
  /// InvalidArgument as covariance() does.
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
