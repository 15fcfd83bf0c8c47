// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "boxplus/system/system.h"

namespace boxplus {

/// If the predicted decrease of a step is below this fraction of chi2, rounding errors alone may prevent a
/// decrease.
inline constexpr double kNegligible = 1e-9;

/// Whether only rounding errors decide how chi2 changes along `step`. Call this if chi2 did not fall along
/// the whole step, although the model predicts a decrease of `predicted`. `chi2` is F at the current
/// estimates.
///
/// Evaluates F at small fractions of the step. There, a smooth function changes in proportion to the
/// fraction. If only rounding errors are left, they are as large as for the whole step, or the estimates do
/// not change at all. If F changes smoothly around the end of the step, the step is only far too long. So
/// this test needs to know neither units nor the size of the estimates.
///
/// Changes `step` during the call only. Returns false if F is not finite or the system is stopped.
bool is_rough(System& system, std::span<double> step, double predicted, double chi2);

}  // namespace boxplus
