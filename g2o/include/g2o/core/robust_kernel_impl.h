// SPDX-License-Identifier: BSD-3-Clause
// The robust kernels of the library; those of boxplus/robust compute them.
#pragma once
#ifndef G2O_ROBUST_KERNEL_IMPL_H
#define G2O_ROBUST_KERNEL_IMPL_H

#include "g2o/core/robust_kernel.h"

namespace g2o {

/// ρ of another kernel, stretched: δ² ρ(e²/δ²).
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

/// Linear beyond δ.
class G2O_CORE_API RobustKernelHuber : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Smoothly towards linear.
class G2O_CORE_API RobustKernelPseudoHuber : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Logarithmic.
class G2O_CORE_API RobustKernelCauchy : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Bounded; δ is in units of the squared error.
class G2O_CORE_API RobustKernelGemanMcClure : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Bounded, exponential.
class G2O_CORE_API RobustKernelWelsch : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Between squared and absolute.
class G2O_CORE_API RobustKernelFair : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Bounded; constant beyond δ.
class G2O_CORE_API RobustKernelTukey : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Squared up to δ, constant beyond.
class G2O_CORE_API RobustKernelSaturated : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

/// Dynamic covariance scaling; δ is Φ, in units of the squared error.
class G2O_CORE_API RobustKernelDCS : public RobustKernel {
 public:
  using RobustKernel::RobustKernel;
  void robustify(double e2, Vector3& rho) const override;
};

}  // namespace g2o

#endif  // G2O_ROBUST_KERNEL_IMPL_H
