// SPDX-License-Identifier: BSD-3-Clause
#include "guess/frame_math.h"

#include <algorithm>
#include <cmath>

namespace boxplus::guess {

SmallMatrix rotation_of(const detail::Frame& frame) {
  const int d = frame.dimension;
  if (!frame.has_rotation) return SmallMatrix::Identity(d, d);
  SmallMatrix rotation(d, d);
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < d; ++j) rotation(i, j) = frame.rotation[i * d + j];
  }
  return rotation;
}

SmallVector translation_of(const detail::Frame& frame) {
  return Eigen::Map<const Eigen::VectorXd>(frame.translation.data(), frame.dimension);
}

void set_rotation(detail::Frame& frame, const SmallMatrix& rotation) {
  const int d = frame.dimension;
  frame.has_rotation = true;
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < d; ++j) frame.rotation[i * d + j] = rotation(i, j);
  }
}

void set_translation(detail::Frame& frame, const SmallVector& translation) {
  Eigen::Map<Eigen::VectorXd>(frame.translation.data(), frame.dimension) = translation;
}

detail::Frame world_frame(int dimension) {
  detail::Frame frame;
  frame.dimension = dimension;
  set_rotation(frame, SmallMatrix::Identity(dimension, dimension));
  return frame;
}

detail::Frame compose(const detail::Frame& a, const detail::Frame& b) {
  detail::Frame result;
  result.dimension = a.dimension;
  const SmallMatrix rotation = rotation_of(a);
  if (b.has_rotation) set_rotation(result, rotation * rotation_of(b));
  set_translation(result, rotation * translation_of(b) + translation_of(a));
  return result;
}

detail::Frame compose_with_inverse(const detail::Frame& a, const detail::Frame& b) {
  detail::Frame result;
  result.dimension = a.dimension;
  const SmallMatrix rotation = rotation_of(a) * rotation_of(b).transpose();
  set_rotation(result, rotation);
  set_translation(result, translation_of(a) - rotation * translation_of(b));
  return result;
}

bool is_finite(const detail::Frame& frame) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(frame.translation.begin(), frame.translation.end(), finite) &&
         (!frame.has_rotation || std::all_of(frame.rotation.begin(), frame.rotation.end(), finite));
}

}  // namespace boxplus::guess
