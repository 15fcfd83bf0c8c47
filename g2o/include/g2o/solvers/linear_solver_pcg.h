// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in pcg/, because older clients include this path.
#pragma once

#include "g2o/solvers/pcg/linear_solver_pcg.h"
