// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "algorithm/roughness.h"
#include "boxplus/algorithm/algorithm.h"

namespace boxplus {

/// The outcome of an iteration whose linear system could not be solved.
inline IterationOutcome outcome_of(LinearStatus status) {
  switch (status) {
    case LinearStatus::kNotFinite:
      return IterationOutcome::kNotFinite;
    case LinearStatus::kStopped:
      return IterationOutcome::kStopped;
    default:
      return IterationOutcome::kNotPositiveDefinite;
  }
}

/// The outcome of an iteration whose System::linearize() returned false.
inline IterationOutcome outcome_without_linearization(const System& system) {
  return system.stopped() ? IterationOutcome::kStopped : IterationOutcome::kNotFinite;
}

/// If damping or the radius makes a step so short that its predicted decrease is negligible, the step is made
/// longer, until the predicted decrease is this fraction of chi2.
inline constexpr double kNoticeable = 1e-6;

/// The outcome if no trial step lowered chi2. `step` is the step that neither damping nor a radius shortens,
/// and `predicted` is its predicted decrease. The estimates are at a minimum if this decrease is negligible.
/// They are also at a minimum if chi2 has only rounding errors along the step.
inline IterationOutcome outcome_without_decrease(System& system, std::span<double> step, double predicted,
                                                 double chi2) {
  return predicted <= kNegligible * chi2 || is_rough(system, step, predicted, chi2)
             ? IterationOutcome::kNoFurtherDecrease
             : IterationOutcome::kNoStepFound;
}

}  // namespace boxplus
