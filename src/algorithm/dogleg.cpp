// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/dogleg.h"

#include "algorithm/outcome.h"
#include "system/whole_vector.h"

namespace boxplus {
namespace {

constexpr double kFirstRegularization = 1e-10, kLastRegularization = 1e2;

}  // namespace

void Dogleg::reset(const Options& options, std::size_t scalars) {
  radius_ = options.initial_radius > 0 ? options.initial_radius : kUnbounded;
  regularization_ = 0;
  regularized_steps_ = 0;
  for (auto* vector : {&scale_, &newton_, &cauchy_, &step_}) vector->resize(scalars);
}

double Dogleg::norm(const System& system, const std::vector<double>& step) const {
  double sum = 0;
  for (std::size_t i = 0; i < step.size(); ++i) sum += scale_[i] * step[i] * step[i];
  return std::sqrt(system.sum(sum));
}

/// Sets D to the scale of the system, with a lower limit above zero.
void Dogleg::scale_from(const System& system) {
  const auto scale = system.scale();
  const double floor = std::max(1e-12 * max_abs(system, scale), 1e-300);
  for (std::size_t i = 0; i < scale_.size(); ++i) scale_[i] = std::max(scale[i], floor);
}

void Dogleg::lower_regularization() {
  regularization_ = regularization_ > kFirstRegularization ? regularization_ / 10 : 0;
}

/// Computes the Gauss-Newton step. If H is not positive definite, uses H + λD instead, with the smallest λ of
/// a geometric series for which H + λD is positive definite. The series begins one value below the λ of the
/// previous iteration.
LinearStatus Dogleg::solve_gauss_newton(System& system, IterationRecord& record) {
  for (;;) {
    const StepResult solved = system.solve({regularization_, Options::DampingScale::kDiagonal}, newton_);
    record.linear_iterations += solved.linear_iterations;
    newton_is_exact_ = solved.exact;
    if (solved.status == LinearStatus::kOk && !any(system, !all_finite(newton_))) {
      regularized_steps_ += regularization_ > 0;
      return LinearStatus::kOk;
    }
    if (solved.status == LinearStatus::kStopped || solved.status == LinearStatus::kNotFinite)
      return solved.status;
    if (regularization_ >= kLastRegularization) return LinearStatus::kNotPositiveDefinite;
    regularization_ = regularization_ == 0 ? kFirstRegularization : 10 * regularization_;
  }
}

/// dᵀHd of the Gauss-Newton step d. If the step is exact, uses (H + λD) d = −g to save a product with H.
double Dogleg::curvature_of_newton(System& system) const {
  if (!newton_is_exact_) return system.curvature(newton_);
  const double damped = norm(system, newton_);
  return -dot(system, system.gradient(), newton_) - regularization_ * damped * damped;
}

/// Computes the Cauchy step, which leads to the minimum of the model along −D⁻¹g. If bounds shorten some of
/// its entries, shortens the rest to the minimum along the new direction. The bounds are convex, so the whole
/// path is then within them.
void Dogleg::find_cauchy_step(System& system) {
  const auto gradient = system.gradient();
  double slope = 0;
  for (std::size_t i = 0; i < cauchy_.size(); ++i) {
    cauchy_[i] = -gradient[i] / scale_[i];
    slope += gradient[i] * cauchy_[i];
  }
  slope = system.sum(slope);
  const double curvature = system.curvature(cauchy_);
  const double length = curvature > 0 ? -slope / curvature : 1;
  for (double& v : cauchy_) v *= length;
  if (any(system, system.clip(cauchy_))) {
    const double clipped_slope = dot(system, gradient, cauchy_),
                 clipped_curvature = system.curvature(cauchy_);
    const double fraction = clipped_curvature > -clipped_slope ? -clipped_slope / clipped_curvature : 1;
    for (double& v : cauchy_) v *= fraction;
  }
  cauchy_norm_ = norm(system, cauchy_);
}

/// Sets step_ to the point of the dogleg path at the distance radius_, or to its end if the path is shorter.
void Dogleg::blend(const System& system) {
  if (newton_norm_ <= radius_) {
    step_ = newton_;
    return;
  }
  if (cauchy_norm_ >= radius_) {
    const double shrink = radius_ / cauchy_norm_;
    for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = shrink * cauchy_[i];
    return;
  }
  // Solves ‖cauchy + β (newton − cauchy)‖ = radius for the root β in [0, 1], without cancellation.
  double a = 0, b = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) {
    const double difference = newton_[i] - cauchy_[i];
    a += scale_[i] * difference * difference;
    b += scale_[i] * cauchy_[i] * difference;
  }
  a = system.sum(a);
  b = system.sum(b);
  const double c = radius_ * radius_ - cauchy_norm_ * cauchy_norm_;
  const double root = std::sqrt(b * b + a * c);
  const double beta = b > 0 ? c / (b + root) : (root - b) / a;
  for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = cauchy_[i] + beta * (newton_[i] - cauchy_[i]);
}

/// Sets step_ to the longest dogleg step within the radius. Returns its predicted decrease.
double Dogleg::find_step(System& system) {
  if (newton_norm_ > radius_ && !have_cauchy_) find_cauchy_step(system);
  blend(system);
  const double curvature = newton_norm_ <= radius_ ? newton_curvature_ : system.curvature(step_);
  return model_decrease(system, step_, curvature);
}

/// Like find_step(), but grows the radius until the predicted decrease is larger than a rounding error.
double Dogleg::find_first_step(System& system, double chi2) {
  double predicted = find_step(system);
  while (newton_norm_ > radius_ && predicted <= kNegligible * chi2) {
    radius_ =
        predicted > 0 ? std::min(newton_norm_, radius_ * (kNoticeable * chi2 / predicted)) : newton_norm_;
    predicted = find_step(system);
  }
  return predicted;
}

void Dogleg::update_radius(double gain, double step_norm) {
  if (!(gain >= 0.25)) {
    radius_ = std::min(radius_, step_norm) * (gain > -1 ? 0.5 : 0.25);
  } else if (gain > 0.75) {
    radius_ = std::max(radius_, 3 * step_norm);
  }
}

IterationOutcome Dogleg::iterate(System& system, double chi2, IterationRecord& record) {
  lower_regularization();
  system.expect({regularization_, Options::DampingScale::kDiagonal});
  constexpr int kMaxTries = 60;
  if (!system.linearize()) return outcome_without_linearization(system);
  scale_from(system);
  const LinearStatus solved = solve_gauss_newton(system, record);
  if (solved != LinearStatus::kOk) return outcome_of(solved);
  newton_norm_ = norm(system, newton_);
  newton_curvature_ = curvature_of_newton(system);
  have_cauchy_ = false;
  for (record.tries = 1; record.tries <= kMaxTries; ++record.tries) {
    const double predicted = record.tries == 1 ? find_first_step(system, chi2) : find_step(system);
    const bool cut_short = newton_norm_ > radius_;
    record.radius = radius_;
    record.predicted_decrease = predicted;
    record.step_max = max_abs(system, step_);
    record.chi2 = system.try_step(step_);
    record.chi2_decrease = chi2 - record.chi2;
    const double gain = record.chi2_decrease / predicted;
    update_radius(gain, norm(system, step_));
    if (record.chi2_decrease > 0 && gain > 0) {
      system.accept();
      return cut_short ? IterationOutcome::kAcceptedShort : IterationOutcome::kAccepted;
    }
    const bool stopped = system.stopped();
    system.reject();
    if (stopped) return IterationOutcome::kStopped;
    record.chi2 = chi2;
    if (!cut_short && is_rough(system, step_, predicted, chi2)) return IterationOutcome::kNoFurtherDecrease;
    if (predicted <= kRounding * chi2) break;  // a smaller step would decrease chi2 even less
  }
  const double newton_decrease = model_decrease(system, newton_, system.curvature(newton_));
  return outcome_without_decrease(system, newton_, newton_decrease, chi2);
}

}  // namespace boxplus
