// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/solver.h"

#include <algorithm>

namespace g2o {

Solver::Solver() = default;
Solver::~Solver() = default;

void Solver::setLevenberg(bool levenberg) {
  _isLevenberg = levenberg;
}

void Solver::setInexactSteps(bool inexactSteps) {
  inexact_steps_ = inexactSteps;
}

void Solver::resizeVector(size_t sx) {
  _xSize = sx;
  const size_t size = sx + _additionalVectorSpace;
  x_memory_.assign(size, 0.0);
  b_memory_.assign(size, 0.0);
  _maxXSize = std::max(_maxXSize, size);
  _x = x_memory_.data();
  _b = b_memory_.data();
}

}  // namespace g2o
