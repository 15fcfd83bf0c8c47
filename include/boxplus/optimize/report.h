// SPDX-License-Identifier: BSD-3-Clause
// The report of a run: status, reason, start, gauge, iterations, fallbacks, timings.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/diagnose/finding.h"
#include "boxplus/graph/jacobian_source.h"
#include "boxplus/linear/linear_statistics.h"
#include "boxplus/options/options.h"
#include "boxplus/system/active_bound.h"
#include "boxplus/system/timings.h"

namespace boxplus {

struct [[nodiscard]] Report {
  enum class Status : std::uint8_t {
    kConverged,     ///< a minimum to within the tolerances
    kNotConverged,  ///< stopped before a minimum (see `reason`); the estimates are the best ones that
                    ///< were found (Gauss-Newton: the last ones)
    kFailed         ///< no step could be computed; the estimates are as for kNotConverged
  };

  enum class Reason : std::uint8_t {
    kCostTolerance,
    kStepTolerance,
    kGradientTolerance,
    kNoFurtherDecrease,  ///< no step lowers chi2 any more, except by rounding errors
    kNothingToOptimize,  ///< no active edge contains a vertex that may move
    kMaxIterations,
    kTimeLimit,
    kStopFlag,
    kCallback,
    kNoStepFound,          ///< every damped step raised chi2
    kRaisedChi2,           ///< Gauss-Newton met a tolerance, but at a higher chi2 than that of its start
    kNotPositiveDefinite,  ///< H is singular or indefinite; `message` names the vertex
    kNotFinite,            ///< an error, a Jacobian, or a sum of them is NaN or Inf; `message` names the edge
    kRejectedEdges,        ///< robust kernels reject edges that the result needs (see RejectionReport)
    /// An Ω is so large, at least in some direction, that other edges are lost by rounding. The estimates are
    /// not at a minimum, and no step improves them. `message` names the edge.
    kWeightSpan,
    /// Constraints (types/constraint.h) are violated by more than rounding errors: they contradict each
    /// other, or the iterations did not suffice. `message` names the worst one.
    kConstraints,
    kGaugeFreedom  ///< the gauge of a component is free, and the policy is GaugePolicy::kError
  };

  /// The requested start, the start that was used, and how the starts compared.
  struct StartReport {
    Start requested = Start::kCurrent;
    Start used = Start::kCurrent;
    double chi2_current = 0;  ///< chi2 of the estimates before the run
    /// Start::kAutomatic: the decrease of chi2 by the first step from the current estimates, as a fraction of
    /// the predicted decrease; NaN if no step was tried.
    double first_step_kept = std::numeric_limits<double>::quiet_NaN();
    double chi2_guess = -1;        ///< chi2 of the initial guess; negative if none was made
    bool ran_both = false;         ///< kAutomatic: both starts were run to their ends
    double chi2_other_final = -1;  ///< final chi2 of the run that was not kept; negative if none
    /// The number of iterations from starts that were given up, or whose results were not kept.
    int other_iterations = 0;
    std::string_view note;  ///< the reason why a guess could not be made, or empty
  };

  struct GaugeReport {
    std::vector<Id> held;  ///< vertices held fixed during the run: one per component with a free gauge
    /// The gauge freedom that remains: a scale, a heading or, depending on GaugePolicy, the whole pose.
    std::vector<detail::GaugeFreedom> free;
    /// The number of tangent directions of vertices that were held fixed because no edge measured them.
    int held_directions = 0;
  };

  /// An edge is rejected if its robust kernel gives it a weight (Graph::weight()) below this.
  static constexpr double kRejectedWeight = 1e-3;

  /// The enabled active edges that their robust kernels reject at the final estimates. A kernel is
  /// redescending if the influence of an edge (its weight times its error) falls to zero for large errors
  /// (robust/redescending.h). A minimum of F that such a kernel makes may be worthless: for example, F is at
  /// a minimum if the kernel rejects all edges.
  ///
  /// So a run that would have converged ends with Reason::kRejectedEdges instead if redescending kernels
  /// reject more than half of their edges, or if `cut_off` is not empty.
  struct RejectionReport {
    /// False if a time limit or Options::stop ended the run. The edges are then not evaluated.
    bool is_known = false;
    std::uint32_t edges = 0;            ///< rejected edges
    std::uint32_t redescending = 0;     ///< edges with redescending kernels, rejected or not
    std::uint32_t by_redescending = 0;  ///< rejected edges with redescending kernels
    /// The vertex with the lowest id of each part of the graph that hangs on edges that redescending kernels
    /// reject: without these edges, the part would be free, or disconnected from all fixed vertices.
    std::vector<Id> cut_off;
  };

  using ActiveBound = detail::ActiveBound;

  /// A constraint (types/constraint.h) at the end of the run. If λ are the multipliers and c is the error of
  /// all constraints, the gradient of F + λᵀc vanishes at the result.
  struct ConstraintResult {
    EdgeRef edge;
    std::vector<double> multipliers;  ///< one per row of the error
  };

  /// The source of the Jacobians of one edge type.
  struct EdgeJacobians {
    std::string_view edge_type;
    detail::JacobianSource source;
  };

  using Timings = detail::Timings;

  Status status = Status::kNotConverged;
  Reason reason = Reason::kMaxIterations;
  std::string message;  ///< one sentence for people

  /// F = Σ ρ(eᵀΩe) over the active edges, at the estimates before the run. NaN if Options::time_limit_s or
  /// Options::stop ended the run before F was evaluated; the estimates are then unchanged.
  double chi2_initial = 0;
  double chi2_final = 0;  ///< F at the estimates after the run
  int iterations = 0;     ///< the number of iterations that led from the start to the result
  StartReport start;
  GaugeReport gauge;
  RejectionReport rejection;
  std::vector<IterationRecord> records;    ///< one for each of these iterations
  std::vector<ActiveBound> active_bounds;  ///< in the order of the plan
  /// The enabled active constraints. F includes their eᵀΩe, which vanish at the result. `records` has the
  /// iterations of all rounds; in the chi2 of these, the constraints have larger weights.
  std::vector<ConstraintResult> constraints;
  double constraint_violation = 0;  ///< the largest |error| of these constraints
  int constraint_rounds = 0;        ///< the number of runs; 0 if there are no constraints
  /// Says why the run failed, as diagnose() does at the final estimates, within the time limit. Empty unless
  /// no step could be computed, no step was found, or the result needs edges that were rejected or whose
  /// weights are lost.
  std::vector<detail::Finding> findings;

  std::string_view algorithm, linear_solver;
  /// The vertices that move: those of active edges, without fixed vertices and without the vertices
  /// gauge.held. Of these, `eliminated` are eliminated by the Schur complement.
  std::uint32_t vertices = 0, eliminated = 0;
  /// The active edges. Of these, `disabled_edges` are disabled; `robust_edges` are enabled and have a robust
  /// kernel.
  std::uint32_t edges = 0, disabled_edges = 0, robust_edges = 0;
  /// The unknowns: the tangent directions of the vertices that move, without fixed directions
  /// (Graph::fix_directions()).
  std::uint32_t scalars = 0;
  /// The rows of the errors of the enabled active edges, without rows whose row of Ω is zero.
  std::uint64_t rows = 0;
  /// The rows minus the unknowns that the edges determine. These are the scalars without the directions of
  /// gauge freedom, which are counted by gauge.free and gauge.held_directions, and without those of a vertex
  /// beyond the rows of its edges, such as one of three if a single camera sees a point. Negative if there
  /// are fewer rows than unknowns that they seem to determine.
  std::int64_t degrees_of_freedom = 0;
  std::vector<EdgeJacobians> jacobians;  ///< the source for each edge type that takes part
  LinearStatistics linear;
  int regularized_steps = 0;  ///< number of steps for which H had to be damped to be positive definite
  /// The number of scalars that were displaced by about 0.01, because all their Jacobians were zero although
  /// chi2 was not at a minimum: for example, if a Range connects positions that coincide, or if a
  /// rotation differs from its measurement by 180°.
  int displaced_directions = 0;
  /// The number of steps that were computed with 32 digits. Such steps are slow. They are needed if an Ω is,
  /// in some direction, more than about 1e10 times as large as others.
  int precise_steps = 0;
  int threads = 1;           ///< maximum number of threads that the options allow
  int workers = 1;           ///< number of threads that linearize or factorize; small problems use fewer
  bool plan_reused = false;  ///< the structure has not changed since the last run
  Timings time;

  bool converged() const { return status == Status::kConverged; }

  /// chi2_final / degrees_of_freedom; NaN unless degrees_of_freedom > 0. If the Ω of every edge is the
  /// inverse covariance of its error, and no edge has a robust kernel, this ratio is 1 with a standard
  /// deviation of √(2 / degrees_of_freedom). If all Ω are too large by a factor, the ratio is this factor.
  ///
  /// A robust kernel reduces the chi2 of its edge, but the edge counts with all its rows, even if its weight
  /// is 0. So with robust kernels, a ratio far above 1 has the same meaning, but a ratio below 1 says nothing
  /// about Ω.
  double chi2_per_degree() const;
  /// F at the estimates from which the iterations started: those before the run, or an initial guess.
  double chi2_start() const { return start.used == Start::kCurrent ? start.chi2_current : start.chi2_guess; }
  /// A sentence if chi2_per_degree() shows that the Ω and the errors do not fit together, and otherwise an
  /// empty text. There is a sentence if the run converged with at least ten degrees of freedom, and the ratio
  /// is above 4 or (unless edges have robust kernels) below 1/4.
  std::string_view chi2_remark() const;
  /// A sentence if the run started from an initial guess and ended above the chi2 of the estimates before the
  /// run. Then Start::kCurrent is better. Otherwise, an empty text.
  std::string_view start_remark() const;
};

std::string_view to_string(Report::Status status);
std::string_view to_string(Report::Reason reason);
/// A table of the iterations and a summary.
std::ostream& operator<<(std::ostream& out, const Report& report);
std::string to_string(const Report& report);

}  // namespace boxplus
