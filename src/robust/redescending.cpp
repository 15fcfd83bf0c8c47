// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/redescending.h"

#include <cmath>

#include "robust/squared_ratio.h"

namespace boxplus {

RobustKernel::Rho Cauchy::operator()(double e2) const {
  const double d2 = delta_ * delta_;
  const double r = squared_ratio(e2, d2);
  const double weight = 1 / (1 + r);
  return {d2 * std::log1p(r), weight, -weight * weight / d2};
}

RobustKernel::Rho GemanMcClure::operator()(double e2) const {
  const double scale = delta_ / (delta_ + e2);
  const double weight = scale * scale;
  return {e2 * scale, weight, -2 * weight / (delta_ + e2)};
}

RobustKernel::Rho Welsch::operator()(double e2) const {
  const double d2 = delta_ * delta_;
  const double weight = std::exp(-e2 / d2);
  return {-d2 * std::expm1(-e2 / d2), weight, -weight / d2};
}

RobustKernel::Rho Tukey::operator()(double e2) const {
  const double d2 = delta_ * delta_;
  if (e2 > d2) return {d2 / 3, 0, 0};
  const double r = e2 / d2, inner = 1 - r;
  // (1 − (1 − r)³) / 3 = r (1 − r + r²/3), without cancellation.
  return {e2 * (1 - r + r * r / 3), inner * inner, -2 * inner / d2};
}

RobustKernel::Rho Saturated::operator()(double e2) const {
  const double d2 = delta_ * delta_;
  if (e2 > d2) return {d2, 0, 0};
  return {e2, 1, 0};
}

RobustKernel::Rho DCS::operator()(double e2) const {
  if (e2 <= delta_) return {e2, 1, 0};
  const double sum = delta_ + e2;
  const double scale = 2 * delta_ / sum;
  const double weight = scale * scale;
  return {delta_ * (3 - 2 * scale), weight, -2 * weight / sum};
}

}  // namespace boxplus
