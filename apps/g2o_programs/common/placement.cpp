// SPDX-License-Identifier: BSD-3-Clause
#include "common/placement.h"

#include <cmath>

namespace boxplus::programs {
namespace {

using detail::Frame;
using detail::RelativeFrame;

/// An entry of the rotation of a frame. A point has the axes of the world.
double rotation(const Frame& frame, int row, int column) {
  if (!frame.has_rotation) return row == column ? 1 : 0;
  return frame.rotation[static_cast<std::size_t>(row * frame.dimension + column)];
}

/// A · B. The result is a point if B has no rotation.
Frame compose(const Frame& a, const Frame& b) {
  Frame result{a.dimension, b.has_rotation, {}, a.translation};
  for (int i = 0; i < a.dimension; ++i) {
    for (int k = 0; k < a.dimension; ++k) {
      const auto row = static_cast<std::size_t>(i);
      result.translation[row] += rotation(a, i, k) * b.translation[static_cast<std::size_t>(k)];
      for (int j = 0; j < a.dimension; ++j) {
        result.rotation[row * static_cast<std::size_t>(a.dimension) + static_cast<std::size_t>(j)] +=
            rotation(a, i, k) * rotation(b, k, j);
      }
    }
  }
  return result;
}

/// The inverse of a rigid motion. A motion without rotation is a translation.
Frame inverse(const Frame& motion) {
  Frame result{motion.dimension, motion.has_rotation, {}, {}};
  for (int i = 0; i < motion.dimension; ++i) {
    for (int j = 0; j < motion.dimension; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      result.rotation[row * static_cast<std::size_t>(motion.dimension) + column] = rotation(motion, j, i);
      result.translation[row] -= rotation(motion, j, i) * motion.translation[column];
    }
  }
  return result;
}

bool is_finite(const Frame& frame) {
  for (const double value : frame.translation) {
    if (!std::isfinite(value)) return false;
  }
  for (const double value : frame.rotation) {
    if (frame.has_rotation && !std::isfinite(value)) return false;
  }
  return true;
}

/// Sets `out` to the frame of a vertex. Returns false if it is neither a pose nor a point of this dimension.
bool get_frame(const Graph& graph, VertexRef vertex, int dimension, Frame& out) {
  return graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, out) && out.dimension == dimension;
}

}  // namespace

void Placement::place_by(EdgeRef edge) {
  if (waiting_.empty()) return;
  RelativeFrame relative;
  if (!graph_.edge_pools()[edge.pool]->relative_frame(edge.slot, relative)) return;
  const std::vector<VertexRef> vertices = graph_.vertices(edge);
  const Frame& motion = relative.motion;
  const VertexRef to = vertices[static_cast<std::size_t>(relative.to)];
  Frame to_frame, from_frame;
  if (!is_finite(motion) || !get_frame(graph_, to, motion.dimension, to_frame)) return;
  if (relative.from == RelativeFrame::kWorld) {
    if (waits(to) && (motion.has_rotation || !to_frame.has_rotation)) set_frame(to, motion);
    return;
  }
  const VertexRef from = vertices[static_cast<std::size_t>(relative.from)];
  if (!get_frame(graph_, from, motion.dimension, from_frame)) return;
  if (waits(from) && waits(to)) keep(graph_.id(from) < graph_.id(to) ? from : to);
  if (waits(to) && (motion.has_rotation || !to_frame.has_rotation)) {
    set_frame(to, compose(from_frame, motion));
  } else if (waits(from) && (motion.has_rotation || !from_frame.has_rotation)) {
    set_frame(from, compose(to_frame, inverse(motion)));
  }
}

void Placement::set_frame(VertexRef vertex, const Frame& frame) {
  graph_.vertex_pools()[vertex.pool]->set_frame(vertex.slot, frame);
  keep(vertex);
}

}  // namespace boxplus::programs
