// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in dense/, because older clients include this path.
#pragma once

#include "g2o/solvers/dense/linear_solver_dense.h"
