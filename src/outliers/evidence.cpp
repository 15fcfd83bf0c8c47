// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/evidence.h"

#include <algorithm>
#include <cmath>

#include "boxplus/manifold/angle.h"

namespace boxplus::outliers {
namespace {

/// The volumes of SO(2) and SO(3), where distances are angles.
double log_of_all_rotations(int dimension) {
  return dimension == 2 ? std::log(2 * kPi) : std::log(8 * kPi * kPi);
}

}  // namespace

Evidence::Evidence(const PoseGraph& poses, std::span<const Motion> estimates)
    : translations_(poses.translations()),
      rotations_(poses.rotations()),
      log_rotations_(log_of_all_rotations(poses.dimension)) {
  Vector3 mean = Vector3::Zero(), squares = Vector3::Zero();
  const double share = 1 / std::max<double>(1, static_cast<double>(estimates.size()));
  for (const Motion& pose : estimates) mean += share * pose.translation;
  for (const Motion& pose : estimates) squares += share * (pose.translation - mean).cwiseAbs2();
  const double largest = squares.maxCoeff();
  extent_ = std::sqrt(12 * squares.sum());
  // A uniform distribution over a length L has the variance L² / 12.
  constexpr double kThinnest = 1e-3;  // a map may be flat
  log_area_ = 0;
  for (int axis = 0; axis < poses.translations(); ++axis)
    log_area_ += std::log(12 * std::max({squares[axis], kThinnest * largest, 1e-300})) / 2;
  most_translation_ = std::max(largest, 1e-300);
}

double Evidence::log_odds(const Deviation& deviation, double scale) const {
  // Beyond a uniform distribution, a deviation tells nothing.
  const double translation = std::min(scale * deviation.spread.translation, most_translation_);
  const double rotation = std::min(scale * deviation.spread.rotation, kPi * kPi / 3);
  const double squares = deviation.squared_translation / translation + deviation.squared_angle / rotation;
  return log_area_ + log_rotations_ -
         (translations_ * std::log(2 * kPi * translation) + rotations_ * std::log(2 * kPi * rotation) +
          squares) /
             2;
}

double Evidence::log_likelihood(std::span<const Deviation> deviations, double scale) const {
  double sum = 0;
  for (const Deviation& deviation : deviations) {
    const double odds = log_odds(deviation, scale);
    sum += odds > 30 ? odds : std::log1p(std::exp(odds));
  }
  return sum;
}

double Evidence::noise_scale(std::span<const Deviation> deviations) const {
  constexpr std::size_t kEnough = 500;
  std::vector<Deviation> sample;
  const std::size_t step = std::max<std::size_t>(1, deviations.size() / kEnough);
  for (std::size_t k = 0; k < deviations.size(); k += step) sample.push_back(deviations[k]);
  double best = 0, most = log_likelihood(sample, 1);
  const auto try_exponent = [&](double exponent) {
    const double likelihood = log_likelihood(sample, std::exp2(exponent));
    if (likelihood <= most) return;
    most = likelihood;
    best = exponent;
  };
  for (int exponent = -24; exponent <= 12; ++exponent) try_exponent(exponent);
  const double near = best;
  for (const double change : {-0.5, -0.25, 0.25, 0.5}) try_exponent(near + change);
  return std::exp2(best);
}

}  // namespace boxplus::outliers
