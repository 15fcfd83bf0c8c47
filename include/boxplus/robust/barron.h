// SPDX-License-Identifier: BSD-3-Clause
// Barron's general and adaptive robust loss (CVPR 2019): a family of kernels with a shape α.
#pragma once

#include "boxplus/robust/kernel_base.h"

namespace boxplus {

/// ρ(e²) = 2c² · (|α−2|/α) · ((e²/(c²|α−2|) + 1)^(α/2) − 1). This is Barron's loss (eq. 13) times 2c², so
/// that ρ(e²) ≈ e² near 0, as for all other kernels. It is smooth in e² and continuous in α. Special cases
/// are, up to a constant factor of the width: the squared error (α = 2), pseudo-Huber (1), Cauchy (0),
/// Geman-McClure (−2) and Welsch (−∞). If α > 2 (including +∞), outliers get more weight than in least
/// squares, and ρ overflows for large errors.
class Barron final : public RobustKernel {
 public:
  /// The shape may be any number or ±∞. c > 0 is the width in units of √e².
  Barron(double shape, double c);
  Rho operator()(double e2) const override;
  std::string_view name() const override { return "Barron"; }
  double delta() const override { return c_; }
  double shape() const { return shape_; }
  std::unique_ptr<RobustKernel> clone() const override;

 private:
  double shape_, c_;
};

}  // namespace boxplus
