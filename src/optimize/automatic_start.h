// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimize/run.h"

namespace boxplus {

/// Start::kAutomatic: minimises from the current estimates where they look like those of the right valley,
/// else from the better of them and a chordal guess, and from the other too where the result disappoints.
RunResult minimize_automatically(Run& run);

}  // namespace boxplus
