// SPDX-License-Identifier: BSD-3-Clause
// Kernels whose influence decreases again for large errors. Gross outliers have almost no influence, but the
// kernels are not convex.
#pragma once

#include "boxplus/robust/kernel_base.h"

namespace boxplus {

/// Cauchy (Lorentzian): δ² ln(1 + e²/δ²).
class Cauchy final : public KernelBase<Cauchy> {
 public:
  static constexpr std::string_view kName = "Cauchy";
  explicit Cauchy(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Geman & McClure (1985): δ e²/(δ + e²). δ is in units of e².
class GemanMcClure final : public KernelBase<GemanMcClure> {
 public:
  static constexpr std::string_view kName = "GemanMcClure";
  explicit GemanMcClure(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Welsch (Leclerc): δ²(1 − exp(−e²/δ²)).
class Welsch final : public KernelBase<Welsch> {
 public:
  static constexpr std::string_view kName = "Welsch";
  explicit Welsch(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Tukey's biweight: δ²/3 (1 − (1 − e²/δ²)³) if |e| ≤ δ, otherwise the constant δ²/3.
class Tukey final : public KernelBase<Tukey> {
 public:
  static constexpr std::string_view kName = "Tukey";
  explicit Tukey(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Truncated least squares: e² if |e| ≤ δ, otherwise the constant δ².
class Saturated final : public KernelBase<Saturated> {
 public:
  static constexpr std::string_view kName = "Saturated";
  explicit Saturated(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

/// Dynamic covariance scaling (Agarwal et al., ICRA 2013). The weight is s² = min(1, 2Φ/(Φ + e²))², and ρ is
/// its integral: e² if e² ≤ Φ, otherwise 3Φ − 4Φ²/(Φ + e²). δ is Φ, in units of e². (The paper's s²e² is not
/// the integral of the weight, and decreases beyond Φ.)
class DCS final : public KernelBase<DCS> {
 public:
  static constexpr std::string_view kName = "DCS";
  explicit DCS(double delta) : KernelBase(delta) {}
  Rho operator()(double e2) const override;
};

}  // namespace boxplus
