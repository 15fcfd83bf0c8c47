// SPDX-License-Identifier: BSD-3-Clause
// Forwards to cholmod/, because older clients include this path.
#pragma once

#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
