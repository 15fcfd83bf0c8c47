// SPDX-License-Identifier: BSD-3-Clause
// The robust kernels of the library, which use the kernels in boxplus/robust. The comments describe ρ as a
// function of the error.
#pragma once
#ifndef G2O_ROBUST_KERNEL_IMPL_H
#define G2O_ROBUST_KERNEL_IMPL_H

#include "g2o/core/robust_kernel.h"

namespace g2o {

/// Scales another kernel ρ. The result is δ² ρ(e²/δ²).
class G2O_CORE_API RobustKernelScaleDelta : public RobustKernel {
 public:
  explicit RobustKernelScaleDelta(const RobustKernelPtr& kernel, double delta = 1.);
  explicit RobustKernelScaleDelta(double delta = 1.);
  const RobustKernelPtr kernel() const { return _kernel; }
  void setKernel(const RobustKernelPtr& ptr);
  void robustify(double error, Vector3& rho) const override;

 protected:
  RobustKernelPtr _kernel;
};

/// Quadratic up to δ, and linear beyond δ.
class G2O_CORE_API RobustKernelHuber : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Changes smoothly from quadratic to linear growth.
class G2O_CORE_API RobustKernelPseudoHuber : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Grows logarithmically for large errors.
class G2O_CORE_API RobustKernelCauchy : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// ρ is bounded. δ has the unit of the squared error.
class G2O_CORE_API RobustKernelGemanMcClure : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// ρ is bounded, and approaches its bound exponentially.
class G2O_CORE_API RobustKernelWelsch : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Almost quadratic for small errors, and almost linear for large errors.
class G2O_CORE_API RobustKernelFair : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Increases smoothly up to δ, and is constant beyond δ.
class G2O_CORE_API RobustKernelTukey : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Quadratic up to δ, and constant beyond δ.
class G2O_CORE_API RobustKernelSaturated : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Dynamic covariance scaling. δ is the parameter Φ, which has the unit of the squared error.
class G2O_CORE_API RobustKernelDCS : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

}  // namespace g2o

#endif  // G2O_ROBUST_KERNEL_IMPL_H
