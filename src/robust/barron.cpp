// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/barron.h"

#include <cmath>
#include <string>

#include "boxplus/base/error.h"
#include "robust/squared_ratio.h"

namespace boxplus {

Barron::Barron(double shape, double c) : shape_(shape), c_(detail::checked_kernel_width(c, "Barron")) {
  if (std::isnan(shape)) throw InvalidArgument("robust kernel Barron: expected a shape α, got NaN");
}

std::unique_ptr<RobustKernel> Barron::clone() const {
  return std::make_unique<Barron>(*this);
}

RobustKernel::Rho Barron::operator()(double e2) const {
  const double c2 = c_ * c_;
  const double r = squared_ratio(e2, c2);
  const double sign = shape_ < 2 ? -1 : 1;
  if (shape_ == 2) return {e2, 1, 0};
  if (std::isinf(shape_)) {
    const double weight = std::exp(sign * 0.5 * r);
    return {sign * 2 * c2 * std::expm1(sign * 0.5 * r), weight, sign * 0.5 * weight / c2};
  }
  // With b = |α − 2| and L = ln(1 + r/b): ρ = c² b L (exp(t) − 1)/t, t = α L / 2. ρ is continuous
  // at α = 0 and α = 2.
  const double b = std::abs(shape_ - 2);
  const double log = std::log1p(r / b);
  const double t = 0.5 * shape_ * log;
  const double ratio = t == 0 ? 1 : std::expm1(t) / t;
  const double weight = std::exp((0.5 * shape_ - 1) * log);
  return {c2 * b * log * ratio, weight, sign * 0.5 / c2 * std::exp((0.5 * shape_ - 2) * log)};
}

}  // namespace boxplus
