// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/optimize/algorithm.h"

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

/// A step that promises to lower chi2 by a smaller fraction may fail to, by rounding alone.
inline constexpr double kNegligible = 1e-9;
/// The fraction of chi2 that a step is made to promise which damping or radius had left with a negligible
/// one.
inline constexpr double kNoticeable = 1e-6;

/// The outcome when no trial step lowered chi2: at a minimum where the step that nothing cuts short promises
/// no more than rounding, or is no larger than rounding (chi2 itself is rounding there).
inline IterationOutcome outcome_without_decrease(double promise, double step_max, double chi2) {
  constexpr double kStep = 1e-9;
  return promise <= kNegligible * chi2 || step_max <= kStep ? IterationOutcome::kNoFurtherDecrease
                                                            : IterationOutcome::kNoStepFound;
}

}  // namespace boxplus
