// SPDX-License-Identifier: BSD-3-Clause
// The initial estimates of a run.
#pragma once

#include <span>
#include <string_view>

#include "boxplus/optimize/report.h"
#include "optimize/descent.h"
#include "optimize/estimates.h"

namespace boxplus {

/// Minimizes from where Options::start says: the current estimates, an initial guess, or the better of both.
/// Fills `report`; report.chi2_current, the chi2 of the current estimates, is given. Adds the time of guesses
/// to `guess_seconds`. `memory` is room for estimates, which a later call may use again.
RunResult minimize_from_starts(Descent& descent, StartReport& report, double& guess_seconds,
                               Estimates& memory);

}  // namespace boxplus
