// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimize/run.h"

namespace boxplus {

/// A held vertex whose own gradient does not vanish at the minimum over the others was no gauge freedom: it
/// is let go, and the run goes on from there. Returns where it ends, or `held` where nothing was to let go.
RunResult release_and_go_on(Run& run, const RunResult& held);

}  // namespace boxplus
