// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/robust_kernel.h"

namespace g2o {

RobustKernel::RobustKernel() = default;
RobustKernel::RobustKernel(double delta) : _delta(delta) {}
RobustKernel::~RobustKernel() = default;

void RobustKernel::setDelta(double delta) {
  _delta = delta;
}

}  // namespace g2o
