// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/gauss_newton.h"

#include "algorithm/outcome.h"
#include "algorithm/roughness.h"
#include "system/whole_vector.h"

namespace boxplus {

void GaussNewton::reset(const Options&, std::size_t scalars) {
  step_.resize(scalars);
}

IterationOutcome GaussNewton::iterate(System& system, double chi2, IterationRecord& record) {
  system.expect({});
  if (!system.linearize()) return outcome_without_linearization(system);
  const StepResult solved = system.solve({}, step_);
  record.linear_iterations = solved.linear_iterations;
  if (solved.status != LinearStatus::kOk) return outcome_of(solved.status);
  record.tries = 1;
  record.step_max = max_abs(system, step_);
  record.predicted_decrease = solved.exact ? -dot(system, system.gradient(), step_)  // because H δ = −g
                                           : model_decrease(system, step_, system.curvature(step_));
  record.chi2 = system.try_step(step_);
  record.chi2_decrease = chi2 - record.chi2;
  if (!std::isfinite(record.chi2)) {
    const bool stopped = system.stopped();
    system.reject();
    return stopped ? IterationOutcome::kStopped : IterationOutcome::kNoStepFound;
  }
  if (record.chi2_decrease <= 0) {
    system.reject();
    if (is_rough(system, step_, record.predicted_decrease, chi2)) return IterationOutcome::kNoFurtherDecrease;
    if (!std::isfinite(system.try_step(step_))) {
      system.reject();
      return IterationOutcome::kStopped;
    }
  }
  system.accept();
  return IterationOutcome::kAccepted;
}

}  // namespace boxplus
