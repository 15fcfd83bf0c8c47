// SPDX-License-Identifier: BSD-3-Clause
// Kernels that are quadratic near zero and linear in the error far away. They are convex in the error, so
// they add no local minima if errors are linear in the estimates. Errors with rotations are not: no such
// promise holds.
#pragma once

#include "boxplus/robust/kernel_base.h"

namespace boxplus {

/// Huber (1964): e² within δ, 2δ|e| − δ² beyond.
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

/// Fair: 2δ²(|e|/δ − ln(1 + |e|/δ)). Its ρ″ = −1/(2δ|e|(1 + |e|/δ)²) is unbounded at 0; below |e| = 1e-6 δ
/// the value at 1e-6 δ is returned, so that it stays finite.
class Fair final : public KernelBase<Fair> {
 public:
  static constexpr std::string_view kName = "Fair";
  explicit Fair(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

}  // namespace boxplus
