// SPDX-License-Identifier: BSD-3-Clause
// The options of a Smoother, and what it reports.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/gauge/gauge.h"
#include "boxplus/graph/handle.h"

namespace boxplus {

/// A distance in the tangent of a vertex: of its lengths in meters, of its angles in radians, and of all
/// other numbers. The tangent of a pose has lengths and angles; that of a point has lengths.
struct TangentDistance {
  double length = 0, angle = 0, other = 0;
};

struct SmootherOptions {
  /// A vertex is linearized anew when its estimate is farther than this from its linearization point.
  TangentDistance relinearize{0.2, 0.03, 0.03};
  /// Smaller changes of a vertex are not passed on to its neighbors.
  TangentDistance noticeable{2e-3, 1e-3, 1e-3};
  /// An update relinearizes until no vertex has to be linearized anew, or until it has done so this often.
  int max_iterations = 20;
  /// An update begins no further iteration after this time, and the next update goes on. At least one
  /// iteration is made.
  double time_limit_s = std::numeric_limits<double>::infinity();
  /// An update linearizes vertices anew only as long as the operations that its factorizations need are
  /// predicted to be at most this many; at least one vertex. Those that are farthest from their linearization
  /// points come first, and the next update goes on with the others. So the time of an update is bounded, and
  /// no clock changes a result. One core does some 10⁹ operations per second.
  double max_flops = std::numeric_limits<double>::infinity();
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
    kConverged,      ///< no vertex is to be linearized anew
    kMaxIterations,  ///< the next update goes on
    kMaxFlops,       ///< the next update goes on
    kTimeLimit,      ///< the next update goes on
    kStopFlag,       ///< the next update goes on
    kNonFinite,      ///< an error or a Jacobian is not finite; the estimates are unchanged
    kNotDetermined,  ///< some vertices are not determined together; the estimates are unchanged
  };
  Reason reason = Reason::kConverged;
  std::string message;  ///< names the vertices of a failure; otherwise empty
  int iterations = 0;
  std::uint32_t vertices = 0;      ///< vertices that can move
  std::uint32_t edges = 0;         ///< edges that take part
  std::uint32_t relinearized = 0;  ///< edges that were linearized in this update
  std::uint32_t ordered = 0;       ///< vertices that were ordered anew
  std::uint32_t refactored = 0;    ///< fronts of the factor that were computed
  double refactored_share = 0;     ///< the share of the unknowns in these fronts, summed over the iterations
  /// Loop closures whose verdicts have changed (SmootherOptions::sets_outliers_aside).
  std::vector<EdgeRef> set_aside, taken_back;
  std::uint32_t marginalized = 0;  ///< vertices that left the lag
  std::uint32_t moved = 0;         ///< estimates that were computed
  double flops = 0;                ///< the operations of the factorizations
  bool started_over = false;       ///< the steps diverged, and optimize() ran over the whole graph
  double time_s = 0;
  /// Vertices that do not move, because nothing fixes their components, or because their own edges do not
  /// determine them yet. Edges of the latter take no part.
  std::vector<detail::GaugeVertex> held;
  std::uint32_t held_directions = 0;  ///< single directions that are held because nothing determines them
  bool converged() const { return reason == Reason::kConverged; }
};

std::string_view to_string(SmootherReport::Reason reason);

/// What an edge would cost and change, predicted from the linear model.
struct EdgePreview {
  double chi2 = 0;  ///< eᵀΩe at the current estimates
  double chi2_increase = 0;  ///< of the minimum of chi2: eᵀ(Ω⁻¹ + JΣJᵀ)⁻¹e, the squared Mahalanobis distance
  int rows = 0;  ///< if the edge is right, chi2_increase has the χ² distribution of so many rows
  std::vector<Eigen::VectorXd> steps;  ///< by how much each of its vertices would move
};

}  // namespace boxplus
