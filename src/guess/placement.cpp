// SPDX-License-Identifier: BSD-3-Clause
#include "guess/placement.h"

#include "guess/frame_math.h"

namespace boxplus {
namespace {

using detail::Frame;
using detail::RelativeFrame;

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
  const VertexRef to = vertices[relative.to];
  Frame to_frame, from_frame;
  if (!guess::is_finite(motion) || !get_frame(graph_, to, motion.dimension, to_frame)) return;
  if (relative.from == RelativeFrame::kWorld) {
    if (waits(to) && (motion.has_rotation || !to_frame.has_rotation)) set_frame(to, motion);
    return;
  }
  const VertexRef from = vertices[relative.from];
  if (!get_frame(graph_, from, motion.dimension, from_frame)) return;
  if (waits(from) && waits(to)) keep(graph_.id(from) < graph_.id(to) ? from : to);
  if (waits(to) && (motion.has_rotation || !to_frame.has_rotation)) {
    set_frame(to, guess::compose(from_frame, motion));
  } else if (waits(from) && (motion.has_rotation || !from_frame.has_rotation)) {
    set_frame(from, guess::compose_with_inverse(to_frame, motion));
  }
}

void Placement::set_frame(VertexRef vertex, const Frame& frame) {
  graph_.vertex_pools()[vertex.pool]->set_frame(vertex.slot, frame);
  keep(vertex);
}

}  // namespace boxplus
