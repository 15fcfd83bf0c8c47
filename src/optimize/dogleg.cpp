// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/dogleg.h"

#include "optimize/outcome.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

constexpr int kMaxTries = 60;
constexpr double kFirstRegularisation = 1e-10, kLastRegularisation = 1e2;

}  // namespace

void Dogleg::reset(const Options& options, std::size_t scalars) {
  radius_ = options.initial_radius > 0 ? options.initial_radius : kUnbounded;
  regularisation_ = 0;
  regularised_steps_ = 0;
  for (auto* vector : {&scale_, &newton_, &cauchy_, &step_}) vector->resize(scalars);
}

double Dogleg::norm(const std::vector<double>& step) const {
  double sum = 0;
  for (std::size_t i = 0; i < step.size(); ++i) sum += scale_[i] * step[i] * step[i];
  return std::sqrt(sum);
}

/// D = diag H, kept away from zero.
void Dogleg::scale_from(const System& system) {
  const auto diagonal = system.diagonal();
  const double floor = std::max(1e-12 * max_abs(diagonal), 1e-300);
  for (std::size_t i = 0; i < scale_.size(); ++i) scale_[i] = std::max(diagonal[i], floor);
}

/// The Gauss-Newton step; where H is not positive definite, of H + λD with the least λ of a geometric ladder
/// that makes it so. The ladder begins one rung below the last one used.
LinearStatus Dogleg::solve_gauss_newton(System& system, IterationRecord& record) {
  regularisation_ = regularisation_ > kFirstRegularisation ? regularisation_ / 10 : 0;
  for (;;) {
    const StepResult solved = system.solve({regularisation_, DampingScale::kDiagonal}, newton_);
    record.linear_iterations += solved.linear_iterations;
    if (solved.status == LinearStatus::kOk && all_finite(newton_)) {
      regularised_steps_ += regularisation_ > 0;
      return LinearStatus::kOk;
    }
    if (solved.status == LinearStatus::kStopped || solved.status == LinearStatus::kNotFinite)
      return solved.status;
    if (regularisation_ >= kLastRegularisation) return LinearStatus::kNotPositiveDefinite;
    regularisation_ = regularisation_ == 0 ? kFirstRegularisation : 10 * regularisation_;
  }
}

/// dᵀHd of the Gauss-Newton step d. A direct solver has (H + λD) d = −g, which spares a product.
double Dogleg::curvature_of_newton(System& system, const IterationRecord& record) const {
  if (record.linear_iterations > 0) return system.curvature(newton_);
  const double damped = norm(newton_);
  return -dot(system.gradient(), newton_) - regularisation_ * damped * damped;
}

/// The minimum of the model along −D⁻¹g.
void Dogleg::find_cauchy_step(System& system) {
  const auto gradient = system.gradient();
  double slope = 0;
  for (std::size_t i = 0; i < cauchy_.size(); ++i) {
    cauchy_[i] = -gradient[i] / scale_[i];
    slope += gradient[i] * cauchy_[i];
  }
  const double curvature = system.curvature(cauchy_);
  const double length = curvature > 0 ? -slope / curvature : 1;
  for (double& v : cauchy_) v *= length;
  cauchy_norm_ = norm(cauchy_);
}

/// step ← the dogleg path at distance radius.
void Dogleg::blend() {
  if (newton_norm_ <= radius_) {
    step_ = newton_;
    return;
  }
  if (cauchy_norm_ >= radius_) {
    const double shrink = radius_ / cauchy_norm_;
    for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = shrink * cauchy_[i];
    return;
  }
  // ‖cauchy + β (newton − cauchy)‖ = radius, the root in [0, 1] written without cancellation.
  double a = 0, b = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) {
    const double difference = newton_[i] - cauchy_[i];
    a += scale_[i] * difference * difference;
    b += scale_[i] * cauchy_[i] * difference;
  }
  const double c = radius_ * radius_ - cauchy_norm_ * cauchy_norm_;
  const double root = std::sqrt(b * b + a * c);
  const double beta = b > 0 ? c / (b + root) : (root - b) / a;
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = cauchy_[i] + beta * (newton_[i] - cauchy_[i]);
}

void Dogleg::update_radius(double gain, double step_norm) {
  if (!(gain >= 0.25)) {
    radius_ = std::min(radius_, step_norm) * (gain > -1 ? 0.5 : 0.25);
  } else if (gain > 0.75) {
    radius_ = std::max(radius_, 3 * step_norm);
  }
}

IterationOutcome Dogleg::iterate(System& system, double chi2, IterationRecord& record) {
  if (!system.linearize()) return IterationOutcome::kNotFinite;
  record.gradient_max = max_abs(system.gradient());
  scale_from(system);
  const LinearStatus solved = solve_gauss_newton(system, record);
  if (solved != LinearStatus::kOk) return outcome_of(solved);
  newton_norm_ = norm(newton_);
  const double newton_curvature = curvature_of_newton(system, record);
  bool have_cauchy = false;
  double largest_promise = 0, largest_step = 0;
  for (record.tries = 1; record.tries <= kMaxTries; ++record.tries) {
    if (newton_norm_ > radius_ && !have_cauchy) {
      find_cauchy_step(system);
      have_cauchy = true;
    }
    record.control = radius_;
    blend();
    const double step_norm = norm(step_);
    const bool is_newton = newton_norm_ <= record.control;
    const double curvature = is_newton ? newton_curvature : system.curvature(step_);
    const double promise = model_decrease(system.gradient(), step_, curvature);
    largest_promise = std::max(largest_promise, promise);
    record.step_max = max_abs(step_);
    largest_step = std::max(largest_step, record.step_max);
    record.chi2 = system.try_step(step_);
    record.chi2_decrease = chi2 - record.chi2;
    const double gain = record.chi2_decrease / promise;
    update_radius(gain, step_norm);
    if (record.chi2_decrease > 0 && gain > 0) {
      system.accept();
      return IterationOutcome::kAccepted;
    }
    system.reject();
    record.chi2 = chi2;
    if (promise <= kRounding * chi2) break;  // smaller steps promise even less
  }
  return outcome_without_decrease(largest_promise, largest_step, chi2);
}

}  // namespace boxplus
