// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimize/run.h"

namespace boxplus {

/// Overwrites the estimates with the initial guess `start`; false, with a note in the report, where there
/// is none.
bool make_guess(Run& run, Start start);

}  // namespace boxplus
