// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/structure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/ply/camera_pyramids.h"
#include "viewer/scene/bundle_view.h"

namespace boxplus::viewer {
namespace {

constexpr std::uint32_t kNotDrawn = 0xFFFFFFFF;

class StructureMaker {
 public:
  StructureMaker(const Graph& graph, Drawn drawn) : graph_(graph), drawn_(drawn), role_(graph) {}

  Structure make() {
    made_.revision = graph_.revision();
    made_.is_bundle = is_bundle(graph_);
    if (made_.is_bundle) made_.leveling = leveling(graph_);
    number_vertices();
    join_vertices();
    find_center();
    return std::move(made_);
  }

 private:
  void number_vertices() {
    const std::vector<int> directions = view_directions(graph_);
    std::vector<VertexGroup> points;
    for (std::uint32_t index = 0; index < directions.size(); ++index) {
      VertexGroup group = group_of(index, directions[index]);
      if (group.slots.empty()) continue;
      (group.shape == Shape::kPoint ? points : made_.vertices).push_back(std::move(group));
    }
    for (const VertexGroup& group : made_.vertices)
      made_.oriented += static_cast<std::uint32_t>(group.slots.size());
    std::move(points.begin(), points.end(), std::back_inserter(made_.vertices));

    for (const auto& pool : graph_.vertex_pools()) numbers_.emplace_back(pool->slots(), kNotDrawn);
    for (VertexGroup& group : made_.vertices) {
      group.first = made_.count;
      for (const std::uint32_t slot : group.slots) {
        numbers_[group.pool][slot] = made_.count++;
        made_.fixed.push_back(graph_.vertex_pools()[group.pool]->fixed(slot) ? 1 : 0);
      }
    }
    if (made_.is_bundle) made_.track_lengths.resize(made_.count - made_.oriented);
  }

  VertexGroup group_of(std::uint32_t index, int direction) {
    const detail::VertexPool& pool = *graph_.vertex_pools()[index];
    VertexGroup group{std::string(pool.type_name()), Shape::kPoint, index, 0, {}};
    detail::Frame frame;
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (!pool.alive(slot) || pool.parameter(slot) || !pool.get_frame(slot, frame)) continue;
      if (!is_drawn({index, slot, pool.generation(slot)})) continue;
      if (frame.has_rotation)
        group.shape = direction == 0 ? Shape::kPose : direction > 0 ? Shape::kCamera : Shape::kCameraBack;
      made_.dimension = std::max(made_.dimension, frame.dimension);
      group.slots.push_back(slot);
    }
    return group;
  }

  bool is_drawn(VertexRef vertex) const {
    if (drawn_ == Drawn::kAll) return true;
    const auto edges = graph_.edges(vertex);
    return edges.empty() ||
           std::any_of(edges.begin(), edges.end(), [&](EdgeRef edge) { return graph_.level(edge) == 0; });
  }

  void join_vertices() {
    struct Group {
      std::vector<std::uint32_t> pairs, edges;
    };
    std::map<std::pair<std::uint32_t, EdgeRole>, Group> groups;
    std::size_t count = 0;
    for (const EdgeRef& edge : graph_.all_edges()) {
      if (drawn_ == Drawn::kTakingPart && graph_.level(edge) != 0) continue;
      std::uint32_t first = kNotDrawn;
      Group* group = nullptr;
      for (const VertexRef& vertex : graph_.vertices(edge)) {
        const std::uint32_t number = numbers_[vertex.pool][vertex.slot];
        if (number == kNotDrawn) continue;
        if (made_.is_bundle && number >= made_.oriented) ++made_.track_lengths[number - made_.oriented];
        if (first == kNotDrawn) {
          first = number;
          continue;
        }
        if (count == Structure::kMostLines) {
          ++made_.left_out;
          continue;
        }
        if (!group) group = &groups[{edge.pool, role_(edge)}];
        group->pairs.insert(group->pairs.end(), {first, number});
        group->edges.push_back(edge.slot);
        ++count;
      }
    }
    for (const auto& [key, group] : groups) {
      made_.line_groups.push_back({std::string(graph_.edge_pools()[key.first]->type_name()), key.second,
                                   key.first, static_cast<std::uint32_t>(made_.line_edges.size()),
                                   static_cast<std::uint32_t>(group.edges.size())});
      made_.lines.insert(made_.lines.end(), group.pairs.begin(), group.pairs.end());
      made_.line_edges.insert(made_.line_edges.end(), group.edges.begin(), group.edges.end());
    }
  }

  /// Takes the median of some positions, so that a few distant vertices do not matter.
  void find_center() {
    constexpr std::size_t kSample = 1000;
    std::array<std::vector<double>, 3> sample;
    for (const VertexGroup& group : made_.vertices) {
      const std::size_t step = 1 + group.slots.size() / kSample;
      for (std::size_t k = 0; k < group.slots.size(); k += step) {
        detail::Frame frame;
        graph_.vertex_pools()[group.pool]->get_frame(group.slots[k], frame);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (std::isfinite(frame.translation[axis])) sample[axis].push_back(frame.translation[axis]);
        }
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) made_.center[axis] = median(std::move(sample[axis]));
  }

  const Graph& graph_;
  Drawn drawn_;
  EdgeRoles role_;
  Structure made_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // by pool and slot
};

}  // namespace

Structure make_structure(const Graph& graph, Drawn drawn) {
  return StructureMaker(graph, drawn).make();
}

}  // namespace boxplus::viewer
