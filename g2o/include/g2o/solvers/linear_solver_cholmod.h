// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in cholmod/, because older clients include this path.
#pragma once

#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
