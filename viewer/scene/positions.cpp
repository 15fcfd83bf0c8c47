// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/positions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace boxplus::viewer {
namespace {

using Quaternion = std::array<float, 4>;

Quaternion orientation(const detail::Frame& frame) {
  if (frame.dimension == 2) {
    const double half = std::atan2(frame.rotation[2], frame.rotation[0]) / 2;
    return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
  }
  const Eigen::Matrix3d rotation =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.rotation.data());
  const Eigen::Quaternionf q = Eigen::Quaterniond(rotation).cast<float>();
  return {q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

Positions read_positions(const Graph& graph, const Structure& structure) {
  constexpr double kFarthest = 1e18;  // products of lengths must fit into a float
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  Positions positions;
  positions.points.reserve(3 * std::size_t{structure.count});
  positions.orientations.reserve(4 * std::size_t{structure.oriented});
  for (const VertexGroup& group : structure.vertices) {
    const detail::VertexPool& pool = *graph.vertex_pools()[group.pool];
    for (const std::uint32_t slot : group.slots) {
      detail::Frame frame;
      pool.get_frame(slot, frame);
      std::array<double, 3> offset{};
      bool is_drawn = true;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(frame.dimension); ++axis) {
        offset[axis] = frame.translation[axis] - structure.center[axis];
        is_drawn = is_drawn && std::abs(offset[axis]) < kFarthest;
      }
      if (group.shape != Shape::kPoint) {
        Quaternion q = orientation(frame);
        const bool is_finite = std::all_of(q.begin(), q.end(), [](float x) { return std::isfinite(x); });
        if (!is_finite) q = {0, 0, 0, 1};
        is_drawn = is_drawn && is_finite;
        positions.orientations.insert(positions.orientations.end(), q.begin(), q.end());
      }
      for (const double each : offset)
        positions.points.push_back(is_drawn ? static_cast<float>(each) : kNowhere);
    }
  }
  return positions;
}

}  // namespace boxplus::viewer
