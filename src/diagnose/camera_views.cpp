// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/camera_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/evidence.h"

namespace boxplus {
namespace {

using Vector3d = std::array<double, 3>;

double norm(const Vector3d& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// The point in the frame of the camera. The pose is T_world_camera or, if `inverse` is true, T_camera_world.
Vector3d in_camera(const detail::Frame& pose, const detail::Frame& point, bool inverse) {
  Vector3d result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i] += inverse ? pose.rotation[3 * i + j] * point.translation[j]
                           : pose.rotation[3 * j + i] * (point.translation[j] - pose.translation[j]);
    }
    if (inverse) result[i] += pose.translation[i];
  }
  return result;
}

/// The ray from the camera to the point, in the world.
Vector3d ray_of(const detail::Frame& pose, const detail::Frame& point, bool inverse) {
  if (!inverse) {
    Vector3d ray;
    for (std::size_t i = 0; i < 3; ++i) ray[i] = point.translation[i] - pose.translation[i];
    return ray;
  }
  const Vector3d local = in_camera(pose, point, true);
  Vector3d ray{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) ray[j] += pose.rotation[3 * i + j] * local[i];
  }
  return ray;
}

/// The edges of a pool, if they are images of points.
class CameraPool {
 public:
  static std::optional<CameraPool> make(const Evidence& evidence, const PoolEvidence& edges) {
    CameraPool result(evidence, edges);
    if (!result.find_places()) return {};
    for (const bool inverse : {false, true}) {
      result.inverse_ = inverse;
      if (result.sees_only_directions()) return result;
    }
    return {};
  }

  std::uint32_t point_pool() const { return vertex_pool(point_); }
  std::uint32_t point_of(std::uint32_t edge) const { return pool_.vertex_slots(edge)[point_]; }
  std::uint32_t pose_of(std::uint32_t edge) const { return pool_.vertex_slots(edge)[pose_]; }
  std::vector<detail::Frame> pose_frames() const { return frames(pose_); }
  std::vector<detail::Frame> point_frames() const { return frames(point_); }
  bool inverse() const { return inverse_; }

 private:
  CameraPool(const Evidence& evidence, const PoolEvidence& edges)
      : evidence_(evidence), edges_(edges), pool_(*evidence.graph.edge_pools()[edges.pool]) {}

  std::uint32_t vertex_pool(int place) const { return pool_.vertex_pool(edges_.edges.front(), place); }
  std::vector<detail::Frame> frames(int place) const {
    const detail::VertexPool& vertices = *evidence_.graph.vertex_pools()[vertex_pool(place)];
    std::vector<detail::Frame> result(vertices.slots());
    for (std::uint32_t slot = 0; slot < result.size(); ++slot) {
      if (vertices.alive(slot)) vertices.get_frame(slot, result[slot]);
    }
    return result;
  }
  detail::Frame frame(std::uint32_t edge, int place) const {
    detail::Frame result;
    const std::uint32_t slot = pool_.vertex_slots(edge)[place];
    evidence_.graph.vertex_pools()[vertex_pool(place)]->get_frame(slot, result);
    return result;
  }

  /// Finds the pose and the point among the vertices of an edge.
  bool find_places() {
    const std::uint32_t first = edges_.edges.front();
    if (!pool_.uniform_shape() || pool_.shape(first).rows != 2) return false;
    int column = 0, poses = 0, points = 0;
    for (int place = 0; place < pool_.arity(first); ++place) {
      const detail::VertexPool& vertices = *evidence_.graph.vertex_pools()[vertex_pool(place)];
      const std::uint32_t slot = pool_.vertex_slots(first)[place];
      detail::Frame frame;
      if (vertices.get_frame(slot, frame)) {
        if (frame.dimension != 3) return false;
        (frame.has_rotation ? pose_ : point_) = place;
        ++(frame.has_rotation ? poses : points);
        if (!frame.has_rotation) point_column_ = column;
      }
      column += vertices.tangent_dim(slot);
    }
    return poses == 1 && points == 1;
  }

  bool sees_only_directions() const {
    constexpr std::size_t kSample = 16;
    constexpr double kZero = 1e-6;
    const std::size_t stride = (edges_.edges.size() + kSample - 1) / kSample;
    std::size_t tested = 0;
    for (std::size_t k = 0; k < edges_.edges.size(); k += stride) {
      const std::uint32_t edge = edges_.edges[k];
      const detail::EdgeShape shape = pool_.shape(edge);
      std::vector<double> error(2), jacobian(2 * static_cast<std::size_t>(shape.cols));
      detail::EdgeTile tile;
      tile.error = error.data();
      tile.jacobian = jacobian.data();
      pool_.linearize(std::span(&edge, 1), tile, evidence_.options.numeric_jacobians);
      const Vector3d ray = ray_of(frame(edge, pose_), frame(edge, point_), inverse_);
      const double* J = jacobian.data() + 2 * point_column_;
      const double change = std::hypot(J[0] * ray[0] + J[2] * ray[1] + J[4] * ray[2],
                                       J[1] * ray[0] + J[3] * ray[1] + J[5] * ray[2]);
      double squares = 0;
      for (int i = 0; i < 6; ++i) squares += J[i] * J[i];
      const double most = kZero * std::sqrt(squares) * norm(ray);
      if (!std::isfinite(most)) continue;
      if (!(change <= most) || most == 0) return false;
      ++tested;
    }
    return tested > 0;
  }

  const Evidence& evidence_;
  const PoolEvidence& edges_;
  const detail::EdgePool& pool_;
  int pose_ = 0, point_ = 0, point_column_ = 0;
  bool inverse_ = false;
};

using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

detail::Frame inverted(const detail::Frame& pose) {
  detail::Frame result = pose;
  const Eigen::Map<const Rotation> R(pose.rotation.data());
  const Eigen::Map<const Eigen::Vector3d> t(pose.translation.data());
  Eigen::Map<Rotation>(result.rotation.data()) = R.transpose();
  Eigen::Map<Eigen::Vector3d>(result.translation.data()) = -(R.transpose() * t);
  return result;
}

/// The pose with the coefficients of its quaternion moved on by one place: with w last if it was read as the
/// first one, or the other way around.
detail::Frame swapped(const detail::Frame& pose, bool was_first) {
  detail::Frame result = pose;
  const Eigen::Quaterniond q(Rotation(Eigen::Map<const Rotation>(pose.rotation.data())));
  const Eigen::Quaterniond other = was_first ? Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y())
                                             : Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w());
  Eigen::Map<Rotation>(result.rotation.data()) = other.toRotationMatrix();
  return result;
}

/// The share of points on one side of their cameras if `change` is applied to the poses.
template <class Change>
double one_sided_share(const PoolEvidence& edges, const CameraPool& cameras, bool inverse, Change&& change) {
  std::vector<detail::Frame> poses = cameras.pose_frames();
  for (detail::Frame& pose : poses) pose = change(pose);
  const std::vector<detail::Frame> points = cameras.point_frames();
  std::size_t in_front = 0;
  for (const std::uint32_t edge : edges.edges)
    in_front += in_camera(poses[cameras.pose_of(edge)], points[cameras.point_of(edge)], inverse)[2] > 0;
  return static_cast<double>(std::max(in_front, edges.edges.size() - in_front)) /
         static_cast<double>(edges.edges.size());
}

/// Files have either T_world_camera or T_camera_world.
void read_otherwise(const PoolEvidence& edges, const CameraPool& cameras, CameraViews& views) {
  views.one_sided_if_inverse =
      one_sided_share(edges, cameras, !cameras.inverse(), [](const auto& x) { return x; });
  for (const bool is_inverse_in_file : {false, true}) {
    for (const bool was_first : {false, true}) {
      const auto change = [&](const detail::Frame& pose) {
        return swapped(is_inverse_in_file == cameras.inverse() ? pose : inverted(pose), was_first);
      };
      views.one_sided_if_swapped =
          std::max(views.one_sided_if_swapped, one_sided_share(edges, cameras, is_inverse_in_file, change));
    }
  }
}

CameraViews views_of(const PoolEvidence& edges, const CameraPool& cameras) {
  constexpr double kFarOff = 1e4;  // chi2
  const std::vector<detail::Frame> poses = cameras.pose_frames(), points = cameras.point_frames();
  CameraViews views;
  views.point_pool = cameras.point_pool();
  views.seen.assign(points.size(), 0);
  views.in_front.assign(points.size(), 0);
  views.nearest.assign(points.size(), std::numeric_limits<double>::infinity());
  std::vector<double> distances;
  distances.reserve(edges.edges.size());
  for (const std::uint32_t edge : edges.edges) {
    const std::uint32_t slot = cameras.point_of(edge);
    const Vector3d point = in_camera(poses[cameras.pose_of(edge)], points[slot], cameras.inverse());
    const double distance = norm(point);
    if (!std::isfinite(distance)) continue;
    views.points += views.seen[slot] == 0;
    ++views.seen[slot];
    views.in_front[slot] += point[2] > 0;
    views.edges_in_front += point[2] > 0;
    views.nearest[slot] = std::min(views.nearest[slot], distance);
    distances.push_back(distance);
  }
  for (const double chi2 : edges.chi2) views.edges_far_off += !(chi2 <= kFarOff);
  if (2 * views.edges_far_off > edges.edges.size()) read_otherwise(edges, cameras, views);
  views.edges = distances.size();
  if (distances.empty()) return views;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  views.median_distance = *middle;
  return views;
}

}  // namespace

double one_sided_share(const CameraViews& views) {
  const double share = static_cast<double>(views.edges_in_front) / static_cast<double>(views.edges);
  return std::max(share, 1 - share);
}

std::vector<CameraViews> find_camera_views(const Evidence& evidence) {
  constexpr std::size_t kFewest = 10;
  std::vector<CameraViews> result;
  for (const PoolEvidence& edges : evidence.pools) {
    const std::optional<CameraPool> cameras = CameraPool::make(evidence, edges);
    if (!cameras) continue;
    CameraViews views = views_of(edges, *cameras);
    if (views.edges >= kFewest) result.push_back(std::move(views));
  }
  return result;
}

}  // namespace boxplus
