// SPDX-License-Identifier: BSD-3-Clause
#include "linear/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxplus {
namespace {

constexpr int kMinimumIterations = 100;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// y += factor x.
void add_scaled(double factor, const std::vector<double>& x, std::vector<double>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

}  // namespace

void ConjugateGradients::resize(std::size_t size) {
  for (auto* vector : {&b_, &x_, &r_, &z_, &p_, &q_}) vector->resize(size);
}

/// Iterates from x_, whose residual is r_, until ‖r_‖ ≤ target. A recurrence updates r_ in each iteration.
SolveResult ConjugateGradients::iterate(Operator multiply, Operator precondition, double target,
                                        int& iterations_left, const StopToken& stop) {
  double rz = 0;
  for (int iteration = 0;; ++iteration) {
    const double residual = std::sqrt(dot(r_, r_));
    if (residual <= target) return {LinearStatus::kOk, iteration};
    if (!std::isfinite(residual)) return {LinearStatus::kNotFinite, iteration};
    if (stop.raised()) return {LinearStatus::kStopped, iteration};
    if (iterations_left-- <= 0) return {LinearStatus::kNotConverged, iteration};
    precondition(r_.data(), z_.data());
    if (stop.raised()) return {LinearStatus::kStopped, iteration};
    const double previous = std::exchange(rz, dot(r_, z_));
    const double beta = iteration == 0 ? 0 : rz / previous;
    for (std::size_t i = 0; i < p_.size(); ++i) p_[i] = z_[i] + beta * p_[i];
    multiply(p_.data(), q_.data());
    const double curvature = dot(p_, q_);
    if (std::isnan(curvature)) return {LinearStatus::kNotFinite, iteration};
    if (curvature <= 0) return {LinearStatus::kNotPositiveDefinite, iteration};
    const double alpha = rz / curvature;
    add_scaled(alpha, p_, x_);
    add_scaled(-alpha, q_, r_);
  }
}

/// Computes the solution in x_. Rounding errors let the residual of the recurrence drift away from the true
/// residual b − A x. If the true residual is still too large at the end, the iteration restarts from it.
SolveResult ConjugateGradients::solve_into_x(Operator multiply, Operator precondition, const double* b,
                                             const SolveControl& control) {
  const std::size_t size = x_.size();
  std::copy_n(b, size, b_.data());
  std::fill(x_.begin(), x_.end(), 0.0);
  r_ = b_;
  const double target = control.relative_tolerance * std::sqrt(dot(b_, b_));
  int left = control.max_iterations > 0 ? control.max_iterations
                                        : std::max(kMinimumIterations, 2 * static_cast<int>(size));
  SolveResult total;
  for (double previous = INFINITY;;) {
    const SolveResult part = iterate(multiply, precondition, target, left, control.stop);
    total.iterations += part.iterations;
    total.status = part.status;
    if (part.status != LinearStatus::kOk) return total;
    multiply(x_.data(), q_.data());
    for (std::size_t i = 0; i < size; ++i) r_[i] = b_[i] - q_[i];
    const double residual = std::sqrt(dot(r_, r_));
    if (residual <= target) return total;
    if (!(residual < 0.5 * previous)) {  // rounding prevents a smaller residual
      total.status = LinearStatus::kNotConverged;
      return total;
    }
    previous = residual;
  }
}

SolveResult ConjugateGradients::solve(Operator multiply, Operator precondition, const double* b, double* x,
                                      const SolveControl& control) {
  const SolveResult result = solve_into_x(multiply, precondition, b, control);
  std::copy(x_.begin(), x_.end(), x);
  return result;
}

}  // namespace boxplus
