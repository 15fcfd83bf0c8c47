// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/trajectory_errors.h"

#include <algorithm>
#include <cmath>

namespace boxplus {
namespace {

/// Returns one length per pair: the length of the true path from the first pair to this pair, in meters.
std::vector<double> traveled(const std::vector<PosePair>& pairs) {
  std::vector<double> lengths(pairs.size(), 0);
  for (std::size_t k = 1; k < pairs.size(); ++k)
    lengths[k] = lengths[k - 1] + (pairs[k].truth.position - pairs[k - 1].truth.position).norm();
  return lengths;
}

/// Calls f(begin, end) for each combination of two pairs that `span` selects.
template <class F>
void for_each_span(const std::vector<PosePair>& pairs, const RelativeSpan& span, F&& f) {
  if (span.distance > 0) {
    const std::vector<double> lengths = traveled(pairs);
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < pairs.size(); ++begin) {
      while (end < pairs.size() && lengths[end] - lengths[begin] < span.distance) ++end;
      if (end < pairs.size()) f(pairs[begin], pairs[end]);
    }
  } else {
    const auto steps = static_cast<std::size_t>(span.steps);
    for (std::size_t end = steps; end < pairs.size(); ++end) f(pairs[end - steps], pairs[end]);
  }
}

/// Returns P₁⁻¹ P₂, with its translation multiplied by `scale`.
TrajectoryPose motion(const TrajectoryPose& first, const TrajectoryPose& second, double scale) {
  TrajectoryPose result;
  result.rotation = first.rotation.transpose() * second.rotation;
  result.position = scale * (first.rotation.transpose() * (second.position - first.position));
  return result;
}

/// Computes the angle from ‖R − I‖² = 8 sin²(θ/2). Unlike the trace of R, this norm is accurate for small
/// angles.
double angle_of(const Matrix<double, 3, 3>& rotation) {
  const double half_sine = (rotation - Matrix<double, 3, 3>::Identity()).norm() / std::sqrt(8.0);
  return 2 * std::asin(std::min(1.0, half_sine));
}

}  // namespace

ErrorStatistics error_statistics(std::vector<double> errors) {
  ErrorStatistics result;
  result.count = errors.size();
  if (errors.empty()) return result;
  const auto count = static_cast<double>(errors.size());
  double sum = 0, squares = 0;
  for (const double error : errors) {
    sum += error;
    squares += error * error;
  }
  result.mean = sum / count;
  result.rmse = std::sqrt(squares / count);
  result.max = *std::max_element(errors.begin(), errors.end());
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  const bool is_odd = errors.size() % 2 == 1;
  result.median = is_odd ? *middle : (*middle + *std::max_element(errors.begin(), middle)) / 2;
  return result;
}

ErrorStatistics absolute_error(const std::vector<PosePair>& pairs, const Alignment& alignment) {
  std::vector<double> distances;
  for (const PosePair& pair : pairs)
    distances.push_back((alignment(pair.result).position - pair.truth.position).norm());
  return error_statistics(std::move(distances));
}

RelativeError relative_error(const std::vector<PosePair>& pairs, double scale, const RelativeSpan& span) {
  std::vector<double> translations, rotations;
  for_each_span(pairs, span, [&](const PosePair& begin, const PosePair& end) {
    const TrajectoryPose error =
        motion(motion(begin.truth, end.truth, 1), motion(begin.result, end.result, scale), 1);
    translations.push_back(error.position.norm());
    rotations.push_back(angle_of(error.rotation));
  });
  return {error_statistics(std::move(translations)), error_statistics(std::move(rotations))};
}

}  // namespace boxplus
