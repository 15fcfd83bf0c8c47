// SPDX-License-Identifier: BSD-3-Clause
// Where older clients look for it.
#pragma once

#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
