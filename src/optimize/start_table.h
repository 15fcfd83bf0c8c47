// SPDX-License-Identifier: BSD-3-Clause
// The starts of the library, in one table.
#pragma once

#include "boxplus/optimize/initial_guess.h"
#include "boxplus/optimize/options.h"

namespace boxplus {

using GuessFunction = GuessResult (*)(Graph&, const Plan&, const GuessLimits&);

/// The guess that a start names. The start is none of kCurrent and kAutomatic.
GuessFunction guess_function(Start start);

}  // namespace boxplus
