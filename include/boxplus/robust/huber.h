// SPDX-License-Identifier: BSD-3-Clause
// Kernels that are quadratic for small errors and linear for large ones. They are convex in the error, so
// they add no local minima if errors are linear in the estimates. There is no such guarantee for errors with
// rotations, which are not linear.
#pragma once

#include "boxplus/robust/kernel_base.h"

namespace boxplus {

/// Huber (1964): e² if |e| ≤ δ, otherwise 2δ|e| − δ².
class Huber final : public KernelBase<Huber> {
 public:
  static constexpr std::string_view kName = "Huber";
  explicit Huber(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Pseudo-Huber: 2δ²(√(1 + e²/δ²) − 1), smooth everywhere.
class PseudoHuber final : public KernelBase<PseudoHuber> {
 public:
  static constexpr std::string_view kName = "PseudoHuber";
  explicit PseudoHuber(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Fair: 2δ²(|e|/δ − ln(1 + |e|/δ)). ρ″ = −1/(2δ|e|(1 + |e|/δ)²) is unbounded at 0. To keep it finite, the ρ″
/// at |e| = 1e-6 δ is also used for smaller errors.
class Fair final : public KernelBase<Fair> {
 public:
  static constexpr std::string_view kName = "Fair";
  explicit Fair(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

}  // namespace boxplus
