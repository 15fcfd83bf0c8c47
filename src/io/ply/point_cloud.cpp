// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply/point_cloud.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "io/ply/camera_pyramids.h"

namespace boxplus {
namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color kUnknownColor{0x8a, 0x93, 0xa3}, kPoseColor{0xd9, 0x48, 0x0f};

/// The colors of the points of a model, by the ids of their vertices.
std::unordered_map<Id, Color> colors_of(const SparseModel* model) {
  std::unordered_map<Id, Color> colors;
  if (!model) return colors;
  const Id first = model->first_point_vertex();
  for (const SparseModel::Point& point : model->points)
    colors[first + static_cast<Id>(point.id)] = point.color;
  return colors;
}

struct PlacedCamera {
  VertexRef vertex;
  detail::Frame frame;
  int direction;  ///< see view_directions()
};

}  // namespace

PointCloud::PointCloud(const GraphFileView& file, std::string_view extension) {
  const Graph& graph = file.graph;
  for (const auto& pool : graph.vertex_pools()) indices_.emplace_back(pool->slots(), kAbsent);
  const std::vector<int> directions = view_directions(graph);
  const std::unordered_map<Id, Color> colors = colors_of(file.model);
  std::vector<PlacedCamera> cameras;
  std::vector<std::array<double, 3>> centers, points;
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) continue;
    const std::array<double, 3>& at = frame.translation;
    if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2])) continue;
    if (const int direction = directions[vertex.pool]; direction != 0 && frame.has_rotation) {
      cameras.push_back({vertex, frame, direction});
      centers.push_back(at);
      continue;
    }
    const auto color = colors.find(graph.id(vertex));
    indices_[vertex.pool][vertex.slot] = vertices.size();
    vertices.push_back({at, frame.has_rotation      ? kPoseColor
                            : color == colors.end() ? kUnknownColor
                                                    : color->second});
    points.push_back(at);
  }
  if (vertices.empty() && cameras.empty()) {
    throw InvalidArgument(
        fmt::format("cannot write {}: expected poses or points with finite positions, got none", extension));
  }
  const double height = pyramid_height(centers, points);
  for (const PlacedCamera& camera : cameras) {
    const std::size_t tip = vertices.size();
    indices_[camera.vertex.pool][camera.vertex.slot] = tip;
    for (const PyramidCorners::value_type& corner : pyramid(camera.frame, camera.direction, height))
      vertices.push_back({corner, kPoseColor});
    for (const auto& [from, to] : kPyramidLines)
      lines.push_back({tip + static_cast<std::size_t>(from), tip + static_cast<std::size_t>(to)});
  }
}

}  // namespace boxplus
