// SPDX-License-Identifier: BSD-3-Clause
// Checks whether a robust kernel, such as your own, obeys the contract of robust/robust_kernel.h. Needs no
// test framework.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "boxplus/autodiff/numeric.h"
#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

/// If `ok` is false, `message` says which rule of the contract is violated, at which error, and by how much.
struct [[nodiscard]] KernelCheck {
  bool ok = true;
  std::string message;
  explicit operator bool() const { return ok; }
};

struct KernelCheckOptions {
  double smallest = 1e-4, largest = 1e4;  ///< sampled range of √e², in units of delta()
  int samples = 200;                      ///< number of samples, evenly spaced on a log scale
  double tolerance = 1e-7;                ///< relative tolerance of derivatives
  bool monotone = true;                   ///< expect ρ′ ≥ 0
  bool unit_slope = true;                 ///< expect ρ′(0) = 1: small errors count as in least squares
};

/// Checks the contract at one squared error.
inline KernelCheck check_kernel_at(const RobustKernel& kernel, double e2,
                                   const KernelCheckOptions& options = {}) {
  const auto fail = [&](const char* law, double expected, double actual) {
    char text[200];
    std::snprintf(text, sizeof text, "%s at e2 = %.6g: expected %.9g, got %.9g", law, e2, expected, actual);
    return KernelCheck{false, std::string(kernel.name()) + ": " + text};
  };
  const RobustKernel::Rho rho = kernel(e2);
  for (const double r : {rho.value, rho.first, rho.second}) {
    if (!std::isfinite(r)) return fail("ρ, ρ′, ρ″ are finite", 0, r);
  }
  if (options.monotone && rho.first < 0) return fail("ρ′ ≥ 0", 0, rho.first);
  if (e2 == 0) return rho.value == 0 ? KernelCheck{} : fail("ρ(0) = 0", 0, rho.value);

  // Differentiates with respect to ln e2, so that the same step size suits all magnitudes. At a kink, the
  // estimated error of the numeric derivative is large, so the check allows a large difference there.
  const auto along = [&](double h, double* values) {
    const RobustKernel::Rho moved = kernel(e2 * std::exp(h));
    values[0] = moved.value;
    values[1] = moved.first;
  };
  detail::NumericOptions numeric;
  numeric.initial_step = 0.02;
  detail::NumericDerivative differentiate(numeric);
  double slope[2];
  const double error = differentiate(along, 2, slope);
  const double first = rho.first * e2, second = rho.second * e2;
  if (!(std::abs(slope[0] - first) <=
        options.tolerance * (std::abs(rho.value) + std::abs(first)) + 10 * error)) {
    return fail("ρ′ is the derivative of ρ", slope[0] / e2, rho.first);
  }
  if (!(std::abs(slope[1] - second) <=
        options.tolerance * (std::abs(rho.first) + std::abs(second)) + 10 * error)) {
    return fail("ρ″ is the derivative of ρ′", slope[1] / e2, rho.second);
  }
  return {};
}

/// Checks the contract at 0 and over a range of errors.
inline KernelCheck check_kernel(const RobustKernel& kernel, const KernelCheckOptions& options = {}) {
  if (KernelCheck zero = check_kernel_at(kernel, 0, options); !zero.ok) return zero;
  if (options.unit_slope && std::abs(kernel(0).first - 1) > options.tolerance) {
    return {false,
            std::string(kernel.name()) + ": expected ρ′(0) = 1, got " + std::to_string(kernel(0).first)};
  }
  for (int i = 0; i < options.samples; ++i) {
    const double e = kernel.delta() * options.smallest *
                     std::pow(options.largest / options.smallest, i / (options.samples - 1.0));
    if (KernelCheck check = check_kernel_at(kernel, e * e, options); !check.ok) return check;
  }
  return {};
}

}  // namespace boxplus
