// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_ROBUST_KERNEL_H
#define G2O_ROBUST_KERNEL_H

#include <memory>

#include "g2o/core/eigen_types.h"
#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// Replaces the chi2 of an edge, eᵀΩe, by ρ(eᵀΩe).
class G2O_CORE_API RobustKernel {
 public:
  RobustKernel();
  explicit RobustKernel(double delta);
  virtual ~RobustKernel();
  /// Sets rho to the values of ρ, ρ′ and ρ″ at the squared error.
  virtual void robustify(double squaredError, Vector3& rho) const = 0;
  virtual void setDelta(double delta);
  double delta() const { return _delta; }

 protected:
  double _delta = 1;
};

using RobustKernelPtr = std::shared_ptr<RobustKernel>;

}  // namespace g2o

#endif  // G2O_ROBUST_KERNEL_H
