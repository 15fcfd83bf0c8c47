// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimize/run.h"

namespace boxplus {

/// Overwrites the estimates with the initial guess `start` and reports its chi2. False if there is no guess,
/// with a note in the report, or if there was no time to evaluate it: put the estimates back then.
bool make_guess(Run& run, Start start);

}  // namespace boxplus
