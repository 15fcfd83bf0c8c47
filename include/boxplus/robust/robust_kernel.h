// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels: an edge contributes ρ(e²) instead of e² = eᵀΩe, so that outliers count less.
//
// A kernel is a function of the SQUARED error. A kernel must obey this contract for 0 ≤ e² ≤ 1e100 δ²
// (testing/check_kernel.h checks it):
//   ρ(0) = 0; ρ, ρ′ and ρ″ are finite, also at 0; ρ′ and ρ″ are the derivatives of ρ with respect to e², if
//   they exist. At a kink, the kernel returns the derivatives on the side of smaller errors.
// ρ′ is the weight of the edge in H and b. The weight should not be negative, because the linearization
// replaces a negative weight by 0, so that the edge has no influence.
#pragma once

#include <memory>
#include <string_view>

#include "boxplus/base/matrix.h"

namespace boxplus {

class RobustKernel {
 public:
  /// ρ and its first and second derivative with respect to the squared error.
  struct Rho {
    double value, first, second;
  };

  virtual ~RobustKernel() = default;
  /// Called once per edge and evaluation, from several threads at a time.
  virtual Rho operator()(double e2) const = 0;
  virtual std::string_view name() const = 0;
  /// The width, in units of the whitened error √e² (of e² for GemanMcClure and DCS).
  virtual double delta() const = 0;
  virtual std::unique_ptr<RobustKernel> clone() const = 0;

 protected:
  RobustKernel() = default;
  RobustKernel(const RobustKernel&) = default;
  RobustKernel& operator=(const RobustKernel&) = default;
};

}  // namespace boxplus
