// SPDX-License-Identifier: BSD-3-Clause
// Findings about points that cameras see.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "optimize/diagnose/evidence.h"
#include "optimize/diagnose/finding_table.h"
#include "optimize/diagnose/sentences.h"

namespace boxplus {
namespace {

using Vector3d = std::array<double, 3>;

double norm(const Vector3d& v) {
  return std::hypot(v[0], v[1], v[2]);
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

/// The edges of a pool, if they are images of points: errors with two rows between a pose and a point in
/// space, which do not change if the point moves along the ray from the camera.
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
  std::uint32_t point_of(std::uint32_t edge) const {
    return pool_.vertex_slots(edge)[static_cast<std::size_t>(point_)];
  }
  /// The point of an edge in the frame of its camera.
  Vector3d seen_point(std::uint32_t edge) const {
    return in_camera(frame(edge, pose_), frame(edge, point_), inverse_);
  }

 private:
  CameraPool(const Evidence& evidence, const PoolEvidence& edges)
      : evidence_(evidence), edges_(edges), pool_(*evidence.graph.edge_pools()[edges.pool]) {}

  std::uint32_t vertex_pool(int place) const { return pool_.vertex_pool(edges_.edges.front(), place); }
  detail::Frame frame(std::uint32_t edge, int place) const {
    detail::Frame result;
    const std::uint32_t slot = pool_.vertex_slots(edge)[static_cast<std::size_t>(place)];
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
      const std::uint32_t slot = pool_.vertex_slots(first)[static_cast<std::size_t>(place)];
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

/// What the edges of a pool say about each point of a vertex pool, by slot.
struct Views {
  std::vector<std::uint32_t> seen, in_front;  ///< edges; those whose point has a positive z
  std::vector<double> nearest;                ///< the distance of the point from the nearest of its cameras
  std::vector<double> distances;              ///< of all edges
  std::size_t edges_in_front = 0;
};

Views views_of(const Evidence& evidence, const PoolEvidence& edges, const CameraPool& cameras) {
  Views views;
  const std::size_t slots = evidence.graph.vertex_pools()[cameras.point_pool()]->slots();
  views.seen.assign(slots, 0);
  views.in_front.assign(slots, 0);
  views.nearest.assign(slots, std::numeric_limits<double>::infinity());
  for (const std::uint32_t edge : edges.edges) {
    const Vector3d point = cameras.seen_point(edge);
    const double distance = norm(point);
    if (!std::isfinite(distance)) continue;
    const std::uint32_t slot = cameras.point_of(edge);
    ++views.seen[slot];
    views.in_front[slot] += point[2] > 0;
    views.edges_in_front += point[2] > 0;
    views.nearest[slot] = std::min(views.nearest[slot], distance);
    views.distances.push_back(distance);
  }
  return views;
}

/// Calls f(views, cameras, number of points) for each pool of images with enough edges.
template <class F>
void for_each_camera_pool(const Evidence& evidence, F&& f) {
  constexpr std::size_t kFewest = 10;
  for (const PoolEvidence& edges : evidence.pools) {
    const std::optional<CameraPool> cameras = CameraPool::make(evidence, edges);
    if (!cameras) continue;
    Views views = views_of(evidence, edges, *cameras);
    if (views.distances.size() < kFewest) continue;
    const auto points = static_cast<std::size_t>(
        std::count_if(views.seen.begin(), views.seen.end(), [](std::uint32_t n) { return n > 0; }));
    f(views, cameras->point_pool(), points);
  }
}

}  // namespace

/// Cameras look along z or along −z, depending on the model. What most edges say decides.
void find_points_behind_cameras(const Evidence& evidence, Findings& out) {
  constexpr double kMost = 0.9;  // with a smaller share, the camera may see points on all sides
  for_each_camera_pool(evidence, [&](Views& views, std::uint32_t pool, std::size_t points) {
    const auto total = static_cast<double>(views.distances.size());
    const double share = static_cast<double>(views.edges_in_front) / total;
    if (share < kMost && share > 1 - kMost) return;
    const bool looks_along_z = share >= kMost;
    Finding finding;
    for (std::uint32_t slot = 0; slot < views.seen.size(); ++slot) {
      const std::uint32_t right =
          looks_along_z ? views.in_front[slot] : views.seen[slot] - views.in_front[slot];
      if (views.seen[slot] > 0 && right == 0) finding.vertices.push_back(evidence.vertex_ref(pool, slot));
    }
    if (finding.vertices.empty()) return;
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = severity_by_share(finding.vertices.size(), points);
    finding.text = fmt::format(
        "{} {} behind all cameras that see {}, from where a run seldom brings {} to the front: triangulate "
        "{} "
        "again, "
        "or remove {}",
        vertices_text(evidence.graph, finding.vertices), by_count(finding.vertices.size(), "is", "are"),
        by_count(finding.vertices.size(), "it", "them"), by_count(finding.vertices.size(), "it", "them"),
        by_count(finding.vertices.size(), "it", "them"), by_count(finding.vertices.size(), "it", "them"));
    out.push_back(std::move(finding));
  });
}

void find_far_points(const Evidence& evidence, Findings& out) {
  constexpr double kFar = 1000;  // times the median distance
  for_each_camera_pool(evidence, [&](Views& views, std::uint32_t pool, std::size_t points) {
    const auto middle = views.distances.begin() + static_cast<std::ptrdiff_t>(views.distances.size() / 2);
    std::nth_element(views.distances.begin(), middle, views.distances.end());
    Finding finding;
    double farthest = 0;
    for (std::uint32_t slot = 0; slot < views.seen.size(); ++slot) {
      if (views.seen[slot] == 0 || !(views.nearest[slot] > kFar * *middle)) continue;
      finding.vertices.push_back(evidence.vertex_ref(pool, slot));
      farthest = std::max(farthest, views.nearest[slot]);
    }
    if (finding.vertices.empty()) return;
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = severity_by_share(finding.vertices.size(), points);
    finding.text = fmt::format(
        "{} {} up to {:.3g} times as far from the cameras as most points, so the rays are parallel and the "
        "depth "
        "is free: remove {}, or add views from farther apart",
        vertices_text(evidence.graph, finding.vertices), by_count(finding.vertices.size(), "is", "are"),
        farthest / *middle, by_count(finding.vertices.size(), "it", "them"));
    out.push_back(std::move(finding));
  });
}

}  // namespace boxplus
