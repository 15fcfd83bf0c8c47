// SPDX-License-Identifier: BSD-3-Clause
// Runs an algorithm for Optimizer::run(), once or several times in a row.
#pragma once

#include <optional>

#include "base/stopwatch.h"
#include "boxplus/algorithm/algorithm.h"
#include "boxplus/base/function_ref.h"
#include "boxplus/optimize/report.h"
#include "optimize/run_stop.h"
#include "system/run_system.h"

namespace boxplus {

struct RunResult {
  Report::Status status = Report::Status::kNotConverged;
  Report::Reason reason = Report::Reason::kMaxIterations;
  double chi2 = 0;
  int iterations = 0;
};

/// Whether the user or the time limit ended the run.
constexpr bool is_interruption(Report::Reason reason) {
  return reason == Report::Reason::kStopFlag || reason == Report::Reason::kTimeLimit ||
         reason == Report::Reason::kCallback;
}

/// The reason why the token is raised.
inline Report::Reason reason_of(const StopToken& stop) {
  return stop.flag_raised() ? Report::Reason::kStopFlag : Report::Reason::kTimeLimit;
}

/// chi2 per unknown below which estimates fit noise-free data exactly: the errors are below 1e-10 standard
/// deviations.
inline constexpr double kExact = 1e-20;

/// Runs an algorithm once or several times. The limits on iterations and time apply to all runs together.
class Descent {
 public:
  /// All arguments must outlive the descent. Runs append to Report::records. `report` has the degrees of
  /// freedom (describe_problem()).
  Descent(Graph& graph, RunSystem& system, Algorithm& algorithm, const Options& options, RunStop& stop,
          const Stopwatch& clock, Report& report);

  /// The following runs use this algorithm.
  void use(Algorithm& algorithm) { algorithm_ = &algorithm; }
  Algorithm& algorithm() const { return *algorithm_; }
  /// The following runs of Levenberg-Marquardt damp with this scale, and no longer with Options::damping.
  void damp_by(Options::DampingScale scale);
  /// The following runs leave this many iterations of Options::max_iterations.
  void leave(int iterations) { left_out_ = iterations; }

  Graph& graph() { return graph_; }
  RunSystem& system() { return system_; }
  const Options& options() const { return options_; }
  const StopToken& stop() const { return stop_.now(); }
  /// The token with the time limit, which applies to runs only after their first step.
  const StopToken& limit() const { return stop_.limit(); }
  std::vector<IterationRecord>& records() { return records_; }

  /// Removes the records, and returns them. Their iterations no longer count against the limit.
  std::vector<IterationRecord> set_aside_records();
  void discard_records();
  /// Replaces the records by those that set_aside_records() returned. Their iterations count again.
  void resume(std::vector<IterationRecord> records);

  /// Runs the algorithm from the current estimates. `chi2` is their chi2. If it converges at a stationary
  /// point that is no minimum, displaces the estimates and goes on (see leave_flat_directions()). If it ends
  /// with a step that damping or a trust region shortened, starts the algorithm again, with the scale of the
  /// current H, until this gains nothing more. If noise does not explain chi2, also tries
  /// Levenberg-Marquardt with the other scale.
  RunResult run(double chi2);
  /// Like run(), but ends with Report::Reason::kCallback after the first iteration for which `wanted` returns
  /// false.
  RunResult run_while(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2);

  /// Whether iterations are left and nothing has stopped the runs.
  bool may_go_on() const { return iterations_left() > 0 && !is_stopped(); }
  /// Whether the token is raised in any of the processes that share the problem.
  bool is_stopped() const { return system_.max(stop().raised() ? 1 : 0) > 0; }
  int iterations_left() const { return options_.max_iterations - left_out_ - iterations_ + uncounted_; }
  /// The number of iterations of all runs together, including those without records.
  int iterations() const { return iterations_; }
  int regularized_steps() const { return regularized_steps_; }
  /// Whether some unknown had a large influence in a run, and hardly any at its end. Such a run may have
  /// ended on a plateau far from a minimum: an exponential function has vanished.
  bool has_lost_influence() const { return has_lost_influence_; }
  /// The number of scalars that leave_flat_directions() displaced.
  int displaced_directions() const { return displaced_directions_; }
  /// The number of rows of the enabled active edges minus the number of unknowns. If Ω is right, this is the
  /// expected chi2.
  double degrees_of_freedom() const { return degrees_of_freedom_; }
  /// Whether chi2 is so low that noise alone explains it. A local minimum far from the global minimum is
  /// unlikely to have such a low chi2.
  bool is_plausible(double chi2) const;

 private:
  RunResult iterate(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2);
  RunResult iterate_until_verified(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2);
  bool gains_again(detail::FunctionRef<bool(const IterationRecord&)> wanted, RunResult& result);
  bool gains_otherwise(detail::FunctionRef<bool(const IterationRecord&)> wanted, RunResult& result);
  const Options& algorithm_options() const { return changed_ ? *changed_ : options_; }
  RunResult iterate_to_end(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2);
  bool call_back(const IterationRecord& record);
  /// The number of unknowns of all processes that share the problem.
  std::size_t unknowns() const { return static_cast<std::size_t>(system_.sum(system_.unknowns())); }

  Graph& graph_;
  RunSystem& system_;
  Algorithm* algorithm_;
  const Options& options_;
  std::optional<Options> changed_;  // the options of the algorithm, after damp_by()
  RunStop& stop_;
  const Stopwatch& clock_;
  std::vector<IterationRecord>& records_;
  double degrees_of_freedom_ = 0;
  int iterations_ = 0, left_out_ = 0, regularized_steps_ = 0, displaced_directions_ = 0;
  bool has_lost_influence_ = false;
  bool ended_short_ = false;  // whether the last iteration converged with a shortened step
  int uncounted_ = 0;         // the iterations that do not count against the limit
};

}  // namespace boxplus
