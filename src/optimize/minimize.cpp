// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/minimize.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "optimize/significance.h"

namespace boxplus {
namespace {

std::optional<Reason> end_before(int iteration, const RunContext& context) {
  if (context.stop.raised()) return reason_of(context.stop);
  if (iteration >= context.max_iterations) return Reason::kMaxIterations;
  return std::nullopt;
}

/// Why an iteration that took no step ends the run.
RunResult ended(IterationOutcome outcome, const StopToken& stop, double chi2, int iterations) {
  switch (outcome) {
    case IterationOutcome::kNoFurtherDecrease:
      return {Status::kConverged, Reason::kNoFurtherDecrease, chi2, iterations};
    case IterationOutcome::kNoStepFound:
      return {Status::kNotConverged, Reason::kNoStepFound, chi2, iterations};
    case IterationOutcome::kStopped:
      return {Status::kNotConverged, reason_of(stop), chi2, iterations};
    case IterationOutcome::kNotFinite:
      return {Status::kFailed, Reason::kNotFinite, chi2, iterations};
    default:
      return {Status::kFailed, Reason::kNotPositiveDefinite, chi2, iterations};
  }
}

/// The part of chi2 that the rounding of its sum may be.
constexpr double kChi2Rounding = 1e-13;

/// Data without noise, fitted: errors of less than 1e-10 standard deviations are all rounding, whatever
/// decrease the model predicts for the next step.
bool is_exact(const IterationRecord& record, double chi2_before, std::size_t unknowns) {
  constexpr double kRounding = 1e-20, kFallsFast = 0.25;
  return record.chi2 <= kRounding * static_cast<double>(unknowns) && record.chi2 > kFallsFast * chi2_before;
}

/// Neither what the iteration gained nor what the model predicted for it is more than `fraction` of chi2.
bool gains_less_than(double fraction, const IterationRecord& record) {
  return std::abs(record.chi2_decrease) <= fraction * record.chi2 &&
         record.predicted_decrease <= fraction * record.chi2;
}

std::optional<Reason> convergence(const Options& options, const IterationRecord& record, double chi2_before,
                                  std::size_t unknowns, double largest_step, bool cut_short) {
  if (record.gradient_max <= options.gradient_tolerance) return Reason::kGradientTolerance;
  if (is_exact(record, chi2_before, unknowns)) return Reason::kNoFurtherDecrease;
  if (cut_short) return std::nullopt;
  if (gains_less_than(kChi2Rounding, record)) return Reason::kNoFurtherDecrease;
  if (record.step_max <= options.step_tolerance * largest_step) return Reason::kStepTolerance;
  if (std::abs(record.chi2_decrease) <= options.cost_tolerance * chi2_before) return Reason::kCostTolerance;
  return std::nullopt;
}

}  // namespace

RunResult minimize(System& system, Algorithm& algorithm, const RunContext& context, double chi2) {
  double largest_step = 0;
  Significance significance(context.options.noise_tolerance, context.degrees_of_freedom);
  for (int iteration = 0;; ++iteration) {
    if (const auto reason = end_before(iteration, context)) {
      return {Status::kNotConverged, *reason, chi2, iteration};
    }
    IterationRecord record;
    record.iteration = static_cast<int>(context.records.size());
    record.chi2 = chi2;
    const IterationOutcome outcome = algorithm.iterate(system, chi2, record);
    const bool cut_short = outcome == IterationOutcome::kAcceptedShort;
    if (outcome != IterationOutcome::kAccepted && !cut_short)
      return ended(outcome, context.stop, chi2, iteration);
    record.time_s = context.clock.seconds();
    context.records.push_back(record);
    const double before = chi2;
    chi2 = record.chi2;
    largest_step = std::max(largest_step, record.step_max);
    const bool wanted = context.go_on(record);
    const std::size_t unknowns = system.gradient().size();
    if (const auto reason = convergence(context.options, record, before, unknowns, largest_step, cut_short)) {
      return {Status::kConverged, *reason, chi2, iteration + 1};
    }
    if (significance.is_lost(record))
      return {Status::kConverged, Reason::kCostTolerance, chi2, iteration + 1};
    if (!wanted) return {Status::kNotConverged, Reason::kCallback, chi2, iteration + 1};
  }
}

}  // namespace boxplus
