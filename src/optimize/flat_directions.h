// SPDX-License-Identifier: BSD-3-Clause
// Leaves stationary points that are not minima.
#pragma once

#include "system/run_system.h"

namespace boxplus {

struct Displacement {
  double chi2 = 0;     ///< of the current estimates
  int directions = 0;  ///< the number of scalars that were displaced; 0 if the estimates have not changed
};

/// Call it after a run that converged; `chi2` belongs to the current estimates. If all Jacobians of a scalar
/// are zero, no algorithm moves it, although chi2 may be at a maximum there: for example, a distance is
/// measured between positions that coincide, or a rotation differs from its measurement by 180°. So this
/// function displaces all such scalars a little, and keeps the displacement if chi2 is then lower. The
/// displacement is the same in every run.
Displacement leave_flat_directions(RunSystem& system, double chi2);

}  // namespace boxplus
