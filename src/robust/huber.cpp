// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/huber.h"

#include <algorithm>
#include <cmath>

#include "robust/squared_ratio.h"

namespace boxplus {

RobustKernel::Rho Huber::operator()(double e2) const {
  if (e2 <= delta_ * delta_) return {e2, 1, 0};
  const double e = std::sqrt(e2);
  const double weight = delta_ / e;
  return {2 * delta_ * e - delta_ * delta_, weight, -0.5 * weight / e2};
}

RobustKernel::Rho PseudoHuber::operator()(double e2) const {
  const double d2 = delta_ * delta_;
  const double root = std::sqrt(1 + squared_ratio(e2, d2));
  const double weight = 1 / root;
  // 2 d² (root − 1), without cancellation and overflow.
  return {e2 / (0.5 * (root + 1)), weight, -0.5 / d2 * weight * weight * weight};
}

namespace {

/// x − ln(1 + x) for x ≥ 0, accurate to rounding.
double x_minus_log1p(double x) {
  if (x > 0.01) return x - std::log1p(x);
  double sum = 0;
  for (int n = 10; n >= 2; --n) sum = 1.0 / n - x * sum;
  return x * x * sum;
}

}  // namespace

RobustKernel::Rho Fair::operator()(double e2) const {
  const double x = std::sqrt(e2) / delta_;
  const double weight = 1 / (1 + x);
  const double x_kept = std::max(x, 1e-6);
  const double slope = 1 / (1 + x_kept);
  return {2 * delta_ * delta_ * x_minus_log1p(x), weight, -0.5 * slope * slope / (delta_ * delta_ * x_kept)};
}

}  // namespace boxplus
