// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply/ply_format.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "io/ply/camera_pyramids.h"

namespace boxplus {
namespace {

using Position = std::array<double, 3>;
using Color = std::array<std::uint8_t, 3>;

constexpr Color kUnknownColor{0x8a, 0x93, 0xa3}, kPoseColor{0xd9, 0x48, 0x0f};

/// The vertices and edges of a polygon file.
class Cloud {
 public:
  explicit Cloud(const GraphFileView& file) : graph_(file.graph), directions_(view_directions(file.graph)) {
    if (file.model) {
      const Id first = file.model->first_point_vertex();
      for (const SparseModel::Point& point : file.model->points)
        colors_[first + static_cast<Id>(point.id)] = point.color;
    }
    for (const VertexRef& vertex : graph_.all_vertices()) sort(vertex);
    if (vertices_.empty() && cameras_.empty())
      throw InvalidArgument("cannot write .ply: expected poses or points with finite positions, got none");
    add_cameras();
  }

  void write(TextSink sink) const {
    if (vertices_.size() > std::numeric_limits<std::int32_t>::max())
      throw InvalidArgument(
          fmt::format("cannot write .ply: expected at most 2^31 vertices, got {}", vertices_.size()));
    sink(header());
    std::string bytes;
    const auto flush = [&](std::size_t at_least) {
      if (bytes.size() < at_least) return;
      sink(bytes);
      bytes.clear();
    };
    constexpr std::size_t kPiece = std::size_t{1} << 18;
    for (const auto& [position, color] : vertices_) {
      for (const double value : position) append(std::bit_cast<std::uint64_t>(value), 8, bytes);
      for (const std::uint8_t channel : color) append(channel, 1, bytes);
      flush(kPiece);
    }
    for (const auto& line : lines_) {
      for (const std::size_t index : line) append(index, 4, bytes);
      flush(kPiece);
    }
    flush(1);
  }

 private:
  struct Vertex {
    Position position;
    Color color;
  };

  void sort(VertexRef vertex) {
    detail::Frame frame;
    if (!graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) return;
    const Position& at = frame.translation;
    if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2])) return;
    if (const int direction = directions_[vertex.pool]; direction != 0 && frame.has_rotation) {
      cameras_.push_back({frame, direction});
      return;
    }
    if (frame.has_rotation) {
      vertices_.push_back({at, kPoseColor});
    } else {
      const auto color = colors_.find(graph_.id(vertex));
      vertices_.push_back({at, color == colors_.end() ? kUnknownColor : color->second});
    }
  }

  void add_cameras() {
    std::vector<Position> centers, points;
    for (const Camera& camera : cameras_) centers.push_back(camera.frame.translation);
    for (const Vertex& vertex : vertices_) points.push_back(vertex.position);
    const double height = pyramid_height(centers, points);
    for (const Camera& camera : cameras_) {
      const std::size_t tip = vertices_.size();
      for (const Position& corner : pyramid(camera.frame, camera.direction, height))
        vertices_.push_back({corner, kPoseColor});
      for (const auto& [from, to] : kPyramidLines)
        lines_.push_back({tip + static_cast<std::size_t>(from), tip + static_cast<std::size_t>(to)});
    }
  }

  std::string header() const {
    std::string text =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", vertices_.size());
    for (const char* name : {"x", "y", "z"}) text += fmt::format("property double {}\n", name);
    for (const char* name : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", name);
    if (!lines_.empty())
      text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", lines_.size());
    return text + "end_header\n";
  }

  static void append(std::uint64_t value, int bytes, std::string& out) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  }

  struct Camera {
    detail::Frame frame;
    int direction;
  };

  const Graph& graph_;
  std::vector<int> directions_;
  std::unordered_map<Id, Color> colors_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<std::size_t, 2>> lines_;
  std::vector<Camera> cameras_;
};

}  // namespace

FileFormat ply_format() {
  return {.name = "ply",
          .extension = ".ply",
          .recognize =
              [](std::string_view text) {
                return text.starts_with("ply\nformat ") || text.starts_with("ply\r\nformat ");
              },
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { Cloud(file).write(sink); }};
}

}  // namespace boxplus
