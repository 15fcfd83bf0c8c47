// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimize/run.h"

namespace boxplus {

/// Minimises from where Options::start says: the current estimates, an initial guess, or the better of both.
RunResult minimize_from_starts(Run& run);

}  // namespace boxplus
