// SPDX-License-Identifier: BSD-3-Clause
// Chooses the initial estimates of a run.
#pragma once

#include <functional>

#include "boxplus/optimize/report.h"
#include "guess/initial_guess.h"
#include "optimize/descent.h"
#include "plan/estimates.h"

namespace boxplus {

/// Scratch memory of minimize_from_starts(), which later calls can reuse.
struct StartMemory {
  Estimates original, fallback;
};

/// Replaces the estimates of the graph by the initial guess of this start.
using MakeGuess = std::function<GuessResult(Start, const GuessLimits&)>;

/// Minimizes from the start that Options::start selects: the current estimates, an initial guess, or the
/// better of both. Fills `report`, but the caller must have set report.chi2_current to the chi2 of the
/// current estimates. Adds the time of guesses to `guess_seconds`. If `guess` is empty, guesses are made from
/// the edges of the descent's plan.
RunResult minimize_from_starts(Descent& descent, Report::StartReport& report, double& guess_seconds,
                               StartMemory& memory, const MakeGuess& guess = {});

}  // namespace boxplus
