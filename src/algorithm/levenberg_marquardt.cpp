// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithm/outcome.h"
#include "system/whole_vector.h"

namespace boxplus {
namespace {

constexpr double kInitialDamping = 1e-5;
constexpr double kMinLambda = 1e-16, kMaxLambda = 1e32;

}  // namespace

void LevenbergMarquardt::reset(const Options& options, std::size_t scalars) {
  scale_ = options.damping;
  user_lambda_ = options.initial_lambda;
  growth_ = 2;
  was_eager_ = false;
  patience_ = 1;
  wait_ = 0;
  // The scale of the identity is known after the first linearization.
  started_ = user_lambda_ > 0 || scale_ != Options::DampingScale::kIdentity;
  if (started_) lambda_ = user_lambda_ > 0 ? std::min(user_lambda_, kMaxLambda) : kInitialDamping;
  step_.resize(scalars);
}

double LevenbergMarquardt::default_damping(const System& system) const {
  const double unit =
      scale_ == Options::DampingScale::kIdentity ? std::max(max_abs(system, system.diagonal()), 1e-300) : 1;
  return kInitialDamping * unit;
}

void LevenbergMarquardt::start_damping(const System& system) {
  started_ = true;
  lambda_ = default_damping(system);
}

void LevenbergMarquardt::raise_damping() {
  lambda_ = std::min(kMaxLambda, lambda_ * growth_);
  growth_ *= 2;
}

/// λ δᵀDδ of the step δ.
double LevenbergMarquardt::damping_of_step(const System& system, double lambda) const {
  if (scale_ == Options::DampingScale::kIdentity) return lambda * dot(system, step_, step_);
  const auto scale = system.scale();
  double sum = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) sum += scale[i] * step_[i] * step_[i];
  return lambda * system.sum(sum);
}

/// Computes the step δ with (H + λD) δ = −g. Its curvature is δᵀ(H + λD)δ = −gᵀδ. If λD contributes more than
/// half of this curvature, the step counts as cut short by damping. The curvature of an exact step needs no
/// product with H.
LinearStatus LevenbergMarquardt::find_step(System& system, double lambda, IterationRecord& record) {
  const StepResult solved = system.solve({lambda, scale_}, step_);
  record.linear_iterations += solved.linear_iterations;
  if (solved.status != LinearStatus::kOk) return solved.status;
  const double slope = dot(system, system.gradient(), step_);
  const double curvature = solved.exact ? -slope - damping_of_step(system, lambda) : system.curvature(step_);
  predicted_ = -(2 * slope + curvature);
  cut_short_ = curvature < -slope / 2;
  return LinearStatus::kOk;
}

/// Like find_step(), but lowers the damping until the predicted decrease is larger than a rounding error.
LinearStatus LevenbergMarquardt::find_first_step(System& system, double chi2, IterationRecord& record) {
  for (;;) {
    const LinearStatus status = find_step(system, lambda_, record);
    const bool too_short = cut_short_ && predicted_ <= kNegligible * chi2 && lambda_ > kMinLambda;
    if (status != LinearStatus::kOk || !too_short) return status;
    lambda_ = std::max(kMinLambda, lambda_ * (predicted_ / (kNoticeable * chi2)));
  }
}

/// The factor of the damping after a step that had the fraction `gain` of its predicted decrease. `at_once`
/// says whether no longer step was rejected before. By the rule of Nielsen ("Damping parameter in Marquardt's
/// method", 1999), the damping hardly changes if `gain` is between 0.5 and 0.8. Then points on their way to
/// infinity take many iterations. So an eager third of the damping is worth a try; but if it leads to a
/// rejected step, the next tries wait, twice as long each time.
double LevenbergMarquardt::damping_factor(double gain, bool at_once) {
  constexpr int kLongestWait = 1 << 20;
  constexpr double kLeast = 1.0 / 3, kLeastAfterRejection = 2.0 / 3;
  const double by_nielsen = std::max(kLeast, 1 - std::pow(2 * gain - 1, 3));
  if (std::exchange(was_eager_, false)) {
    patience_ = at_once ? 1 : std::min(kLongestWait, 2 * patience_);
    if (!at_once) wait_ = patience_;
  }
  if (gain <= 0.5) return by_nielsen;
  if (!at_once) return std::max(kLeastAfterRejection, by_nielsen);
  if (wait_ > 0) {
    --wait_;
    return by_nielsen;
  }
  was_eager_ = by_nielsen > kLeast;
  return kLeast;
}

/// If the step lowers chi2, takes it, updates the damping, and returns true. Otherwise, takes no step and
/// returns false.
bool LevenbergMarquardt::take_step(System& system, double chi2, IterationRecord& record) {
  record.step_max = max_abs(system, step_);
  record.predicted_decrease = predicted_;
  record.chi2 = system.try_step(step_);
  record.chi2_decrease = chi2 - record.chi2;
  const double gain = record.chi2_decrease / predicted_;
  if (!(record.chi2_decrease > 0 && gain > 0)) {
    system.reject();
    record.chi2 = chi2;
    return false;
  }
  system.accept();
  lambda_ = std::max(kMinLambda, lambda_ * damping_factor(gain, record.tries == 1));
  growth_ = 2;
  return true;
}

IterationOutcome LevenbergMarquardt::iterate(System& system, double chi2, IterationRecord& record) {
  if (started_) system.expect({lambda_, scale_});
  constexpr int kMaxTries = 30;
  if (!system.linearize()) return outcome_without_linearization(system);
  if (!started_) start_damping(system);
  double longest_step = 0, longest_lambda = lambda_, longest_prediction = 0;
  bool longest_cut_short = false;
  LinearStatus last = LinearStatus::kOk;
  for (record.tries = 1; record.tries <= kMaxTries; ++record.tries) {
    last = record.tries == 1 ? find_first_step(system, chi2, record) : find_step(system, lambda_, record);
    record.lambda = lambda_;
    if (last == LinearStatus::kStopped) return IterationOutcome::kStopped;
    if (last == LinearStatus::kOk) {
      if (take_step(system, chi2, record))
        return cut_short_ ? IterationOutcome::kAcceptedShort : IterationOutcome::kAccepted;
      if (system.stopped()) return IterationOutcome::kStopped;
      if (!cut_short_ && is_rough(system, step_, predicted_, chi2))
        return IterationOutcome::kNoFurtherDecrease;
      if (record.step_max >= longest_step) {
        longest_step = record.step_max;
        longest_lambda = lambda_;
        longest_prediction = predicted_;
        longest_cut_short = cut_short_;
      }
      if (predicted_ <= kRounding * chi2) break;  // a smaller step would decrease chi2 even less
    }
    raise_damping();
  }
  if (last == LinearStatus::kOk && (longest_cut_short || longest_prediction > kNegligible * chi2))
    last = find_step(system, longest_cut_short ? default_damping(system) : longest_lambda, record);
  if (last != LinearStatus::kOk) return outcome_of(last);
  return outcome_without_decrease(system, step_, predicted_, chi2);
}

}  // namespace boxplus
