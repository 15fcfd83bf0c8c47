// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply/ply_format.h"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "boxplus/base/error.h"
#include "io/ply/point_cloud.h"

namespace boxplus {
namespace {

std::string header(const PointCloud& cloud) {
  std::string text =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", cloud.vertices.size());
  for (const char* name : {"x", "y", "z"}) text += fmt::format("property double {}\n", name);
  for (const char* name : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", name);
  if (!cloud.lines.empty())
    text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", cloud.lines.size());
  return text + "end_header\n";
}

void append(std::uint64_t value, int bytes, std::string& out) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
}

void write_ply(const PointCloud& cloud, TextSink sink) {
  if (cloud.vertices.size() > std::numeric_limits<std::int32_t>::max())
    throw InvalidArgument(
        fmt::format("cannot write .ply: expected at most 2^31 vertices, got {}", cloud.vertices.size()));
  sink(header(cloud));
  std::string bytes;
  const auto flush = [&](std::size_t at_least) {
    if (bytes.size() < at_least) return;
    sink(bytes);
    bytes.clear();
  };
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  for (const auto& [position, color] : cloud.vertices) {
    for (const double value : position) append(std::bit_cast<std::uint64_t>(value), 8, bytes);
    for (const std::uint8_t channel : color) append(channel, 1, bytes);
    flush(kPiece);
  }
  for (const auto& line : cloud.lines) {
    for (const std::size_t index : line) append(index, 4, bytes);
    flush(kPiece);
  }
  flush(1);
}

}  // namespace

FileFormat ply_format() {
  return {.name = "ply",
          .extension = ".ply",
          .recognize =
              [](std::string_view text) {
                return text.starts_with("ply\nformat ") || text.starts_with("ply\r\nformat ");
              },
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { write_ply(PointCloud(file, ".ply"), sink); }};
}

}  // namespace boxplus
