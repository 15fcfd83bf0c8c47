// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/descent.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithm/levenberg_marquardt.h"
#include "optimize/flat_directions.h"
#include "optimize/significance.h"
#include "system/whole_vector.h"

namespace boxplus {
namespace {

/// The result of a run that ends with an iteration that took no step.
RunResult ended(IterationOutcome outcome, const StopToken& stop, double chi2, int iterations) {
  switch (outcome) {
    case IterationOutcome::kNoFurtherDecrease:
      return {Report::Status::kConverged, Report::Reason::kNoFurtherDecrease, chi2, iterations};
    case IterationOutcome::kNoStepFound:
      return {Report::Status::kNotConverged, Report::Reason::kNoStepFound, chi2, iterations};
    case IterationOutcome::kStopped:
      return {Report::Status::kNotConverged, reason_of(stop), chi2, iterations};
    case IterationOutcome::kNotFinite:
      return {Report::Status::kFailed, Report::Reason::kNotFinite, chi2, iterations};
    default:
      return {Report::Status::kFailed, Report::Reason::kNotPositiveDefinite, chi2, iterations};
  }
}

/// Whether chi2 is above the chi2 at the start of a run by more than a rounding error.
bool is_above(double start, double chi2, std::size_t unknowns) {
  constexpr double kRelative = 1e-9;
  return chi2 > (1 + kRelative) * start + kExact * static_cast<double>(unknowns);
}

/// The relative rounding error of chi2, which is a sum.
constexpr double kChi2Rounding = 1e-13;

/// Whether the estimates fit noise-free data exactly. Then chi2 has only rounding errors, even if the model
/// predicts a further decrease for the next step. Runs that converge quadratically get one more step.
bool is_exact(const IterationRecord& record, double chi2_before, std::size_t unknowns) {
  constexpr double kFallsFast = 0.25, kTiny = 1e-10;
  const double limit = kExact * static_cast<double>(unknowns);
  return record.chi2 <= kTiny * limit || (record.chi2 <= limit && record.chi2 >= kFallsFast * chi2_before);
}

/// Whether both the decrease of chi2 and the predicted decrease are at most `fraction` times chi2.
bool gains_less_than(double fraction, const IterationRecord& record) {
  return std::abs(record.chi2_decrease) <= fraction * record.chi2 &&
         record.predicted_decrease <= fraction * record.chi2;
}

/// `step` is the largest entry of the step, in standard deviations.
std::optional<Report::Reason> convergence(const Options& options, const IterationRecord& record,
                                          double chi2_before, double step, std::size_t unknowns,
                                          bool cut_short) {
  if (record.gradient_max <= options.gradient_tolerance) return Report::Reason::kGradientTolerance;
  if (is_exact(record, chi2_before, unknowns)) return Report::Reason::kNoFurtherDecrease;
  if (cut_short) return std::nullopt;
  if (gains_less_than(kChi2Rounding, record)) return Report::Reason::kNoFurtherDecrease;
  if (step <= options.step_tolerance) return Report::Reason::kStepTolerance;
  // A step that is too long may happen to end at the same chi2, far from a minimum.
  constexpr double kPossible = 1e-6;
  if (std::abs(record.chi2_decrease) <= options.cost_tolerance * chi2_before &&
      record.predicted_decrease <= kPossible * chi2_before)
    return Report::Reason::kCostTolerance;
  return std::nullopt;
}

}  // namespace

Descent::Descent(Graph& graph, RunSystem& system, Algorithm& algorithm, const Options& options, RunStop& stop,
                 const Stopwatch& clock, Report& report)
    : graph_(graph),
      system_(system),
      algorithm_(&algorithm),
      options_(options),
      stop_(stop),
      clock_(clock),
      records_(report.records),
      degrees_of_freedom_(static_cast<double>(report.degrees_of_freedom)) {}

RunResult Descent::run(double chi2) {
  return run_while([](const IterationRecord&) { return true; }, chi2);
}

RunResult Descent::run_while(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2) {
  if (!std::isfinite(chi2)) return {Report::Status::kFailed, Report::Reason::kNotFinite, chi2, 0};
  RunResult result = iterate_until_verified(wanted, chi2);
  const bool is_stationary =
      result.status == Report::Status::kConverged || result.reason == Report::Reason::kNotPositiveDefinite;
  if (!is_stationary) return result;
  const Displacement displacement = leave_flat_directions(system_, result.chi2);
  if (displacement.directions == 0) return result;
  displaced_directions_ += displacement.directions;
  return iterate_until_verified(wanted, displacement.chi2);
}

void Descent::damp_by(Options::DampingScale scale) {
  changed_ = options_;
  changed_->damping = scale;
  changed_->initial_lambda = 0;
}

bool Descent::is_plausible(double chi2) const {
  constexpr double kAtMost = 2;
  return chi2 <= std::max(1.0, kAtMost * degrees_of_freedom_);
}

/// A short step may gain nothing because of the scale of its damping or because of its radius, although
/// longer ones lower chi2. So if a run converges with such a step, other steps must confirm it.
RunResult Descent::iterate_until_verified(detail::FunctionRef<bool(const IterationRecord&)> wanted,
                                          double chi2) {
  RunResult result = iterate(wanted, chi2);
  while (result.status == Report::Status::kConverged && ended_short_ && may_go_on()) {
    if (!gains_again(wanted, result) && !gains_otherwise(wanted, result)) break;
  }
  return result;
}

/// Begins again from the result, as a new run would. If the first step does not gain noticeably, ends after
/// it and returns false; the result is then still converged.
bool Descent::gains_again(detail::FunctionRef<bool(const IterationRecord&)> wanted, RunResult& result) {
  constexpr double kNoticeable = 1e-4;
  constexpr int kMostSteps = 10;
  const double before = result.chi2;
  int steps = is_plausible(before) ? 1 : kMostSteps;
  bool has_gained = false;
  const auto gains = [&](const IterationRecord& record) {
    has_gained = record.chi2 < (1 - kNoticeable) * before;
    return wanted(record) && (has_gained || --steps > 0);
  };
  const RunResult again = iterate(gains, before);
  if (has_gained) {
    result = again;
  } else {
    result.chi2 = std::min(before, again.chi2);
  }
  return has_gained;
}

/// Like gains_again(), with Levenberg-Marquardt and the other scale of damping.
bool Descent::gains_otherwise(detail::FunctionRef<bool(const IterationRecord&)> wanted, RunResult& result) {
  using enum Options::DampingScale;
  if (is_plausible(result.chi2) || !may_go_on()) return false;
  LevenbergMarquardt other;
  Algorithm* const usual = std::exchange(algorithm_, &other);
  const std::optional<Options> changed = changed_;
  damp_by(algorithm_options().damping == kIdentity ? kDiagonal : kIdentity);
  const bool gains = gains_again(wanted, result);
  algorithm_ = usual;
  changed_ = changed;
  return gains;
}

RunResult Descent::iterate(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2) {
  algorithm_->reset(algorithm_options(), system_.plan().scalars());
  system_.forget_scale();
  ended_short_ = false;
  RunResult result = iterate_to_end(wanted, chi2);
  if (result.status == Report::Status::kConverged && is_above(chi2, result.chi2, unknowns())) {
    result.status = Report::Status::kNotConverged;
    result.reason = Report::Reason::kRaisedChi2;
  }
  const bool loses_influence = any(system_, !std::ranges::equal(system_.diagonal(), system_.scale()));
  has_lost_influence_ = has_lost_influence_ || loses_influence;
  iterations_ += result.iterations;
  regularized_steps_ += algorithm_->regularized_steps();
  return result;
}

RunResult Descent::iterate_to_end(detail::FunctionRef<bool(const IterationRecord&)> wanted, double chi2) {
  const int most = iterations_left();
  Significance significance(options_.noise_tolerance, degrees_of_freedom_, static_cast<double>(unknowns()));
  for (int iteration = 0;; ++iteration) {
    if (is_stopped()) return {Report::Status::kNotConverged, reason_of(stop()), chi2, iteration};
    if (iteration >= most)
      return {Report::Status::kNotConverged, Report::Reason::kMaxIterations, chi2, iteration};
    IterationRecord record;
    record.iteration = static_cast<int>(records_.size()) + 1;
    record.chi2 = chi2;
    system_.trial().order().begin_iteration();
    const IterationOutcome outcome = algorithm_->iterate(system_, chi2, record);
    system_.trial().order().expect_no_trial("Algorithm::iterate");
    const bool cut_short = outcome == IterationOutcome::kAcceptedShort;
    if (outcome == IterationOutcome::kNoStepFound && chi2 <= kExact * static_cast<double>(unknowns()))
      return {Report::Status::kConverged, Report::Reason::kNoFurtherDecrease, chi2, iteration};
    if (outcome != IterationOutcome::kAccepted && !cut_short) return ended(outcome, stop(), chi2, iteration);
    stop_.apply_limit();
    system_.set_stop(stop());
    system_.trial().describe_step(chi2, record);
    record.step_max = system_.max(record.step_max);
    record.gradient_max = max_abs(system_, system_.gradient());
    record.time_s = clock_.seconds();
    records_.push_back(record);
    const double before = chi2;
    chi2 = record.chi2;
    const double variance = std::min(before, chi2) / std::max(1.0, degrees_of_freedom_);
    const double step = system_.max(system_.trial().step_in_deviations()) / std::sqrt(variance);
    const bool goes_on = !any(system_, !(call_back(record) && wanted(record)));
    const bool changes_bounds = system_.changes_bounds();
    ended_short_ = cut_short;
    if (const auto reason =
            convergence(options_, record, before, step, unknowns(), cut_short || changes_bounds))
      return {Report::Status::kConverged, *reason, chi2, iteration + 1};
    if (significance.is_lost(record) && !changes_bounds)
      return {Report::Status::kConverged, Report::Reason::kCostTolerance, chi2, iteration + 1};
    if (!goes_on) return {Report::Status::kNotConverged, Report::Reason::kCallback, chi2, iteration + 1};
  }
}

std::vector<IterationRecord> Descent::set_aside_records() {
  uncounted_ += static_cast<int>(records_.size());
  return std::exchange(records_, {});
}

void Descent::discard_records() {
  uncounted_ += static_cast<int>(records_.size());
  records_.clear();  // keeps its memory
}

void Descent::resume(std::vector<IterationRecord> records) {
  records_ = std::move(records);
  uncounted_ -= static_cast<int>(records_.size());
}

bool Descent::call_back(const IterationRecord& record) {
  if (!options_.callback) return true;
  const std::uint64_t revision = graph_.revision();
  const std::shared_ptr<detail::LifeState> life = graph_.life();
  const bool go_on = options_.callback(record);
  if (life->is_over || graph_.revision() != revision)
    throw InvalidArgument("Options::callback changed the structure of the graph");
  return go_on;
}

}  // namespace boxplus
