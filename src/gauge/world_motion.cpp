// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/world_motion.h"

#include <Eigen/Geometry>
#include <array>

namespace boxplus {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A frame of 2 or 3 dimensions, as a pose in 3-D.
struct Pose {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d translation = Vector3d::Zero();

  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

Pose pose_of(const detail::Frame& frame) {
  const int d = frame.dimension;
  Pose pose;
  pose.translation.head(d) = Eigen::Map<const Eigen::VectorXd>(frame.translation.data(), d);
  if (frame.has_rotation)
    pose.rotation.topLeftCorner(d, d) = Eigen::Map<const RowMajor>(frame.rotation.data(), d, d);
  return pose;
}

detail::Frame frame_of(const Pose& pose, int dimension, bool has_rotation) {
  detail::Frame frame{dimension, has_rotation, {}, {}};
  Eigen::Map<Eigen::VectorXd>(frame.translation.data(), dimension) = pose.translation.head(dimension);
  Eigen::Map<RowMajor>(frame.rotation.data(), dimension, dimension) =
      pose.rotation.topLeftCorner(dimension, dimension);
  return frame;
}

/// The pose after motion number `m` of the world has moved it by `amount`.
Pose moved(const Pose& pose, const WorldMotions& motions, int m, double amount) {
  const Vector3d arm = pose.translation - motions.center;
  if (m < motions.translations())
    return {pose.rotation, pose.translation + amount * motions.length * Vector3d::Unit(m)};
  if (m == motions.in_world() - 1) return {pose.rotation, motions.center + (1 + amount) * arm};
  const int axis = motions.dimension == 2 ? 2 : m - motions.translations();
  const Matrix3d turn = Eigen::AngleAxisd(amount, Vector3d::Unit(axis)).toRotationMatrix();
  return {turn * pose.rotation, motions.center + turn * arm};
}

}  // namespace

bool world_frame(const Graph& graph, VertexSlot vertex, WorldRole role, int dimension, detail::Frame& out) {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  if (role == WorldRole::kNone || !pool.get_frame(vertex.slot, out) || out.dimension != dimension)
    return false;
  if (role == WorldRole::kInverse) out = frame_of(pose_of(out).inverse(), dimension, out.has_rotation);
  return true;
}

/// Uses central differences, whose truncation error is below 1e-9 of the result. Their steps are large, so
/// that rounding errors are small, too, if the world is far from the origin.
MatrixXd motion_tangents(const Graph& graph, VertexSlot vertex, WorldRole role, const WorldMotions& motions) {
  constexpr double kAmount = 0.01;
  constexpr std::array kWeights{8.0 / 12, -1.0 / 12};  // of order 4
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  const int dim = pool.tangent_dim(vertex.slot);
  MatrixXd tangents = MatrixXd::Zero(dim, motions.count());
  for (std::size_t i = 0; i < motions.own.size(); ++i) {
    if (motions.own[i].vertex == vertex)
      tangents(motions.own[i].component, motions.in_world() + static_cast<int>(i)) = 1;
  }
  detail::Frame frame;
  if (!world_frame(graph, vertex, role, motions.dimension, frame)) return tangents;
  const Pose pose = pose_of(frame);
  Eigen::VectorXd forward(dim), backward(dim);
  const auto tangent_after = [&](int m, double amount, double* tangent) {
    Pose there = moved(pose, motions, m, amount);
    if (role == WorldRole::kInverse) there = there.inverse();
    pool.tangent_to_frame(vertex.slot, frame_of(there, frame.dimension, frame.has_rotation), tangent);
  };
  const auto add_difference = [&](int m, double amount, double weight) {
    tangent_after(m, amount, forward.data());
    tangent_after(m, -amount, backward.data());
    tangents.col(m) += weight * (forward - backward);
  };
  for (int m = 0; m < motions.in_world(); ++m) {
    for (std::size_t k = 0; k < kWeights.size(); ++k)
      add_difference(m, kAmount * static_cast<double>(k + 1), kWeights[k] / kAmount);
  }
  if (role == WorldRole::kSimilarity) tangents(dim - 1, motions.in_world() - 1) += 1;
  return tangents;
}

}  // namespace boxplus
