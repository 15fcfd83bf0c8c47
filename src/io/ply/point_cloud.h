// SPDX-License-Identifier: BSD-3-Clause
// What files of pictures (PLY, VRML) show of a graph.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "boxplus/io/file_format.h"

namespace boxplus {

/// The points and poses of a graph. Points have the colors of the COLMAP model, or are gray. A camera is a
/// pyramid of five vertices, with the tip first, and eight lines; any other pose is one vertex. Elements
/// without a finite position are left out.
struct PointCloud {
  struct Vertex {
    std::array<double, 3> position;  ///< meters
    std::array<std::uint8_t, 3> color;
  };
  static constexpr std::size_t kAbsent = std::numeric_limits<std::size_t>::max();

  std::vector<Vertex> vertices;  ///< points and poses by id, then the corners of the pyramids
  std::vector<std::array<std::size_t, 2>> lines;  ///< of the pyramids, as indices of vertices

  /// The index of an element of the graph, or of the tip of its pyramid; kAbsent if it has none.
  std::size_t index_of(VertexRef vertex) const { return indices_[vertex.pool][vertex.slot]; }

  /// Throws InvalidArgument if nothing has a finite position. `extension` is that of the format, for
  /// messages.
  PointCloud(const GraphFileView& file, std::string_view extension);

 private:
  std::vector<std::vector<std::size_t>> indices_;  // per pool and slot
};

}  // namespace boxplus
