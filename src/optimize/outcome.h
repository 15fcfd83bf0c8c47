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

/// The outcome when no trial step lowered chi2: at a minimum where the best of them promised no more than
/// rounding, or where the largest was no more than rounding (chi2 itself is rounding there).
inline IterationOutcome outcome_without_decrease(double largest_promise, double largest_step, double chi2) {
  constexpr double kPromise = 1e-9, kStep = 1e-9;
  return largest_promise <= kPromise * chi2 || largest_step <= kStep ? IterationOutcome::kNoFurtherDecrease
                                                                     : IterationOutcome::kNoStepFound;
}

}  // namespace boxplus
