// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/block_solver.h"

namespace g2o {

BlockSolverBase::~BlockSolverBase() = default;

}  // namespace g2o
