// SPDX-License-Identifier: BSD-3-Clause
#include "guess/frame_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "guess/frame_math.h"

namespace boxplus::guess {
namespace {

/// The mean of the diagonal entries [first, first + count) of Ω.
double mean_information(const detail::InformationView& information, int first, int count) {
  double sum = 0;
  for (int i = first; i < first + count; ++i) sum += information(i, i);
  return count > 0 ? sum / count : 0;
}

}  // namespace

FrameGraph::FrameGraph(Graph& graph, const Plan& plan, const StopToken& stop) : graph_(&graph), view_(graph) {
  PacedStop pace(stop, kBetweenStops);
  flags_.assign(nodes(), 0);
  mark_movable(plan);
  measurements_.reserve(plan.edge_count);
  read_edges(plan, pace);
  list_touching(pace);
}

void FrameGraph::mark_movable(const Plan& plan) {
  for (const VertexRef& vertex : plan.block_vertex) {
    if (!graph_->vertex_pools()[vertex.pool]->parameter(vertex.slot)) {
      flags_[node(vertex.pool, vertex.slot)] |= kMovable;
    }
  }
}

void FrameGraph::read_edges(const Plan& plan, PacedStop& pace) {
  for (const EdgeList& list : plan.edges) {
    for (const std::uint32_t edge : list.edges) {
      pace.step();
      read_edge(list.pool, edge);
    }
  }
}

void FrameGraph::read_edge(std::uint32_t pool_index, std::uint32_t edge) {
  const detail::EdgePool& pool = *graph_->edge_pools()[pool_index];
  detail::RelativeFrame relative;
  if (!pool.enabled(edge) || !pool.relative_frame(edge, relative) || !is_finite(relative.motion)) return;
  const auto slots = pool.vertex_slots(edge);
  const auto node_at = [&](int i) { return node(pool.vertex_pool(edge, i), slots[i]); };
  const int arity = static_cast<int>(slots.size());
  if (relative.to < 0 || relative.to >= arity || relative.from >= arity) return;
  const bool absolute = relative.from < 0;
  const Node to = node_at(relative.to), from = absolute ? kWorld : node_at(relative.from);
  if (from == to || !look_at(to, relative.motion.dimension)) return;
  const bool has_rotation = relative.motion.has_rotation && pose(to);
  if (!absolute && !look_at(from, relative.motion.dimension)) return;
  if (!absolute && !pose(from) && pose(to)) return;  // a point does not determine a pose
  if (!movable(to) && (absolute || !movable(from))) return;

  const detail::InformationView information = pool.information(edge);
  const double unit = relative.rotation_unit;
  const double rotation_weight =
      has_rotation
          ? unit * unit * mean_information(information, relative.rotation_row, relative.rotation_rows)
          : 0;
  const double translation_weight =
      mean_information(information, relative.translation_row, relative.translation_rows);
  if (rotation_weight <= 0 && translation_weight <= 0) return;
  flags_[to] |= kUsed;
  if (!absolute) flags_[from] |= kUsed;
  const bool from_point = !absolute && !pose(from);
  measurements_.push_back({from, to, pool_index, edge, has_rotation, has_rotation || !pose(to),
                           has_rotation || from_point, rotation_weight, translation_weight});
}

/// Records the kind of a vertex. Returns false if the vertex is neither a pose nor a point of this dimension.
bool FrameGraph::look_at(Node node, int dimension) {
  std::uint8_t& flags = flags_[node];
  if ((flags & kSeen) == 0) {
    flags |= kSeen;
    detail::Frame frame;
    if (view_.vertices_of(node).get_frame(view_.slot_of(node), frame)) {
      flags |= frame.has_rotation ? kPose : kPoint;
      if (frame.dimension == 2) flags |= kPlanar;
    }
  }
  return (flags & (kPose | kPoint)) != 0 && this->dimension(node) == dimension;
}

void FrameGraph::list_touching(PacedStop& pace) {
  const auto row = [&](Node node) { return node == kWorld ? nodes() : node; };
  touching_start_.assign(nodes() + 2, 0);
  for (const Measurement& m : measurements_) {
    pace.step();
    ++touching_start_[row(m.from) + 1];
    ++touching_start_[row(m.to) + 1];
  }
  std::partial_sum(touching_start_.begin(), touching_start_.end(), touching_start_.begin());
  touching_.resize(touching_start_.back());
  std::vector<std::uint32_t> next(touching_start_.begin(), touching_start_.end() - 1);
  for (std::uint32_t k = 0; k < measurements_.size(); ++k) {
    pace.step();
    touching_[next[row(measurements_[k].from)]++] = k;
    touching_[next[row(measurements_[k].to)]++] = k;
  }
}

std::span<const std::uint32_t> FrameGraph::touching(Node node) const {
  const Node row = node == kWorld ? nodes() : node;
  return std::span(touching_).subspan(touching_start_[row], touching_start_[row + 1] - touching_start_[row]);
}

detail::Frame FrameGraph::motion(const Measurement& measurement) const {
  detail::RelativeFrame relative;
  graph_->edge_pools()[measurement.pool]->relative_frame(measurement.edge, relative);
  relative.motion.has_rotation = measurement.has_rotation;
  return relative.motion;
}

Id FrameGraph::id(Node node) const {
  return view_.vertices_of(node).id(view_.slot_of(node));
}

std::vector<Node> FrameGraph::movable_by_id(const StopToken& stop) const {
  PacedStop pace(stop);
  std::vector<Node> result;
  for (Node node = 0; node < nodes(); ++node) {
    if (used(node) && movable(node)) result.push_back(node);
  }
  const auto rank = [&](Node node) { return std::pair(!pose(node), id(node)); };
  std::sort(result.begin(), result.end(), [&](Node a, Node b) {
    pace.step();
    return rank(a) < rank(b);
  });
  return result;
}

detail::Frame FrameGraph::frame(Node node) const {
  detail::Frame frame;
  view_.vertices_of(node).get_frame(view_.slot_of(node), frame);
  return frame;
}

void FrameGraph::set_frame(Node node, const detail::Frame& frame) {
  graph_->vertex_pools()[view_.pool_of(node)]->set_frame(view_.slot_of(node), frame);
}

}  // namespace boxplus::guess
