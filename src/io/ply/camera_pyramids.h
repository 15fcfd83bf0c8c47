// SPDX-License-Identifier: BSD-3-Clause
// The cameras of a graph as pyramids, for pictures: the tip is the center, and the base lies in the direction
// of view. Everything is inline, because programs also use it, and the library does not export functions of
// private headers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

inline bool is_reprojection(const detail::EdgePool& pool) {
  const std::string_view name = pool.type_name();
  return name.starts_with("Reprojection<") || name.starts_with("CalibratedReprojection<");
}

/// Per vertex pool: 1 if its poses are cameras that look along z, −1 if they look along −z, and 0 if they are
/// no cameras. The first vertex of a reprojection error is a camera.
inline std::vector<int> view_directions(const Graph& graph) {
  std::vector<int> directions(graph.vertex_pools().size());
  for (std::uint32_t pool = 0; pool < graph.edge_pools().size(); ++pool) {
    const detail::EdgePool& edges = *graph.edge_pools()[pool];
    if (!is_reprojection(edges)) continue;
    for (std::uint32_t slot = 0; slot < edges.slots(); ++slot) {
      if (!edges.alive(slot)) continue;
      directions[graph.vertices({pool, slot, edges.generation(slot)}).front().pool] =
          edges.type_name().ends_with("<BAL>") ? -1 : 1;
      break;
    }
  }
  return directions;
}

using PyramidCorners = std::array<std::array<double, 3>, 5>;
/// Pairs of corners.
inline constexpr std::array<std::array<int, 2>, 8> kPyramidLines{
    {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {2, 3}, {3, 4}, {4, 1}}};

/// The corners of a pyramid of the given height, with the tip first.
inline PyramidCorners pyramid(const detail::Frame& camera, int direction, double height) {
  constexpr double kHalfWidth = 0.6, kHalfHeight = 0.45;
  constexpr std::array<std::array<double, 2>, 5> kBase{{{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  PyramidCorners corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::array<double, 3> p{kHalfWidth * height * kBase[k][0], kHalfHeight * height * kBase[k][1],
                                  k == 0 ? 0 : direction * height};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[k][i] = camera.translation[i] + camera.rotation[3 * i] * p[0] +
                      camera.rotation[3 * i + 1] * p[1] + camera.rotation[3 * i + 2] * p[2];
    }
  }
  return corners;
}

/// The median of finite values; 0 if there are none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A height for pyramids: half of the median distance between one camera and the next, within 1 % and 8 % of
/// the median distance of the points from the middle camera, if there are points.
inline double pyramid_height(const std::vector<std::array<double, 3>>& cameras,
                             const std::vector<std::array<double, 3>>& points) {
  const auto distance = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  if (cameras.empty()) return 0;
  std::vector<double> steps, distances;
  for (std::size_t i = 1; i < cameras.size(); ++i) steps.push_back(distance(cameras[i - 1], cameras[i]));
  for (const auto& point : points) distances.push_back(distance(point, cameras[cameras.size() / 2]));
  const double wanted = median(std::move(steps)) / 2, range = median(std::move(distances));
  return range > 0 ? std::clamp(wanted, 0.01 * range, 0.08 * range) : wanted;
}

}  // namespace boxplus
