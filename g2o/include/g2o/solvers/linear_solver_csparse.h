// SPDX-License-Identifier: BSD-3-Clause
// Where older clients look for it.
#pragma once

#include "g2o/solvers/csparse/linear_solver_csparse.h"
