// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in csparse/, because older clients include this path.
#pragma once

#include "g2o/solvers/csparse/linear_solver_csparse.h"
