// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/levenberg_marquardt.h"

#include "optimize/outcome.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

constexpr double kInitialDamping = 1e-5;
constexpr double kMinLambda = 1e-16, kMaxLambda = 1e32;
constexpr int kMaxTries = 30;

}  // namespace

void LevenbergMarquardt::reset(const Options& options, std::size_t scalars) {
  scale_ = options.damping;
  user_lambda_ = options.initial_lambda;
  growth_ = 2;
  started_ = false;
  step_.resize(scalars);
}

void LevenbergMarquardt::start_damping(const System& system) {
  started_ = true;
  const double unit = scale_ == DampingScale::kIdentity ? std::max(max_abs(system.diagonal()), 1e-300) : 1;
  lambda_ = user_lambda_ > 0 ? user_lambda_ : kInitialDamping * unit;
}

void LevenbergMarquardt::raise_damping() {
  lambda_ = std::min(kMaxLambda, lambda_ * growth_);
  growth_ *= 2;
}

IterationOutcome LevenbergMarquardt::iterate(System& system, double chi2, IterationRecord& record) {
  if (!system.linearize()) return IterationOutcome::kNotFinite;
  if (!started_) start_damping(system);
  record.gradient_max = max_abs(system.gradient());
  double largest_promise = 0, largest_step = 0;
  LinearStatus last = LinearStatus::kOk;
  for (record.tries = 1; record.tries <= kMaxTries; ++record.tries) {
    record.control = lambda_;
    const StepResult solved = system.solve({lambda_, scale_}, step_);
    last = solved.status;
    record.linear_iterations += solved.linear_iterations;
    if (last == LinearStatus::kStopped) return IterationOutcome::kStopped;
    if (last == LinearStatus::kOk) {
      const double promise = model_decrease(system.gradient(), step_, system.curvature(step_));
      largest_promise = std::max(largest_promise, promise);
      record.step_max = max_abs(step_);
      largest_step = std::max(largest_step, record.step_max);
      record.chi2 = system.try_step(step_);
      record.chi2_decrease = chi2 - record.chi2;
      const double gain = record.chi2_decrease / promise;
      if (record.chi2_decrease > 0 && gain > 0) {
        system.accept();
        const double cubed = 1 - std::pow(2 * gain - 1, 3);
        lambda_ = std::max(kMinLambda, lambda_ * std::max(1.0 / 3, cubed));
        growth_ = 2;
        return IterationOutcome::kAccepted;
      }
      system.reject();
      record.chi2 = chi2;
      if (promise <= kRounding * chi2) break;  // smaller steps promise even less
    }
    raise_damping();
  }
  if (last != LinearStatus::kOk) return outcome_of(last);
  return outcome_without_decrease(largest_promise, largest_step, chi2);
}

}  // namespace boxplus
