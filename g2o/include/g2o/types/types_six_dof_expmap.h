// SPDX-License-Identifier: BSD-3-Clause
// Forwards to sba/types_six_dof_expmap.h, because older clients include this path.
#pragma once

#include "g2o/types/sba/types_six_dof_expmap.h"
