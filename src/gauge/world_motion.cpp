// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/world_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace boxplus {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector3d = Eigen::Vector3d;

/// A frame of 2 or 3 dimensions, as a pose in 3-D.
struct Pose {
  Matrix3 rotation = Matrix3::Identity();
  Vector3d translation = Vector3d::Zero();

  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

Pose pose_of(const detail::Frame& frame) {
  Pose pose;
  for (int i = 0; i < frame.dimension; ++i) {
    pose.translation[i] = frame.translation[static_cast<std::size_t>(i)];
    for (int j = 0; frame.has_rotation && j < frame.dimension; ++j)
      pose.rotation(i, j) = frame.rotation[static_cast<std::size_t>(i * frame.dimension + j)];
  }
  return pose;
}

detail::Frame frame_of(const Pose& pose, int dimension, bool has_rotation) {
  detail::Frame frame{dimension, has_rotation, {}, {}};
  for (int i = 0; i < dimension; ++i) {
    frame.translation[static_cast<std::size_t>(i)] = pose.translation[i];
    for (int j = 0; j < dimension; ++j)
      frame.rotation[static_cast<std::size_t>(i * dimension + j)] = pose.rotation(i, j);
  }
  return frame;
}

/// The rotation by `angle` about coordinate axis number `axis`.
Matrix3 rotation_about(int axis, double angle) {
  const int y = (axis + 1) % 3, z = (axis + 2) % 3;
  Matrix3 r = Matrix3::Identity();
  r(y, y) = r(z, z) = std::cos(angle);
  r(z, y) = std::sin(angle);
  r(y, z) = -r(z, y);
  return r;
}

/// The pose after motion number `m` has moved it by `amount`.
Pose moved(const Pose& pose, const WorldMotions& motions, int m, double amount) {
  Pose result = pose;
  if (m < motions.translations()) {
    result.translation[m] += amount * motions.length;
    return result;
  }
  const Vector3d center(motions.center.data()), arm = pose.translation - center;
  m -= motions.translations();
  if (m == motions.rotations()) {
    result.translation = center + (1 + amount) * arm;
    return result;
  }
  const Matrix3 turn = rotation_about(motions.dimension == 2 ? 2 : m, amount);
  return {turn * pose.rotation, center + turn * arm};
}

}  // namespace

bool world_frame(const detail::VertexPool& pool, std::uint32_t slot, WorldRole role, int dimension,
                 detail::Frame& out) {
  if (role == WorldRole::kNone || !pool.get_frame(slot, out) || out.dimension != dimension) return false;
  if (role == WorldRole::kInverse) out = frame_of(pose_of(out).inverse(), dimension, out.has_rotation);
  return true;
}

/// Uses central differences, whose truncation error is below 1e-9 of the result.
void motion_tangents(const detail::VertexPool& pool, std::uint32_t slot, WorldRole role,
                     const WorldMotions& motions, double* out) {
  constexpr double kAmount = 3e-5;
  const auto dim = static_cast<std::size_t>(pool.tangent_dim(slot));
  std::fill_n(out, dim * static_cast<std::size_t>(motions.count()), 0.0);
  detail::Frame frame;
  if (!world_frame(pool, slot, role, motions.dimension, frame)) return;
  const Pose pose = pose_of(frame);
  std::vector<double> backward(dim);
  for (int m = 0; m < motions.count(); ++m, out += dim) {
    const auto tangent_after = [&](double amount, double* tangent) {
      Pose there = moved(pose, motions, m, amount);
      if (role == WorldRole::kInverse) there = there.inverse();
      pool.tangent_to_frame(slot, frame_of(there, frame.dimension, frame.has_rotation), tangent);
    };
    tangent_after(kAmount, out);
    tangent_after(-kAmount, backward.data());
    for (std::size_t i = 0; i < dim; ++i) out[i] = (out[i] - backward[i]) / (2 * kAmount);
  }
}

}  // namespace boxplus
