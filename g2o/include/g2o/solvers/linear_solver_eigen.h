// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in eigen/, because older clients include this path.
#pragma once

#include "g2o/solvers/eigen/linear_solver_eigen.h"
