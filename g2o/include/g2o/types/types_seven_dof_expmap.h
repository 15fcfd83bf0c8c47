// SPDX-License-Identifier: BSD-3-Clause
// Forwards to sim3/types_seven_dof_expmap.h, because older clients include this path.
#pragma once

#include "g2o/types/sim3/types_seven_dof_expmap.h"
