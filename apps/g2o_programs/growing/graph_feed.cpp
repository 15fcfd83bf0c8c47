// SPDX-License-Identifier: BSD-3-Clause
#include "growing/graph_feed.h"

#include <algorithm>
#include <memory>
#include <string>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"

namespace boxplus::programs {
namespace {

bool is_parameter(const Graph& graph, VertexRef vertex) {
  return graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
}

template <class Ref>
const Tag& tag_of(const Graph& graph, Ref element, std::string_view type) {
  if (const Tag* tag = default_registry().tag_of(graph, element)) return *tag;
  throw InvalidArgument("expected a graph of types with tags, got one with " + std::string(type));
}

}  // namespace

GraphFeed::GraphFeed(const Graph& source, const std::vector<EdgeRef>& edges, Graph& target)
    : source_(source), target_(target), placement_(target) {
  for (const VertexRef& parameter : source.all_parameters()) copy(parameter, true);
  items_.reserve(edges.size());
  for (const EdgeRef& edge : edges) items_.push_back(item_of(edge));
  std::stable_sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) {
    return a.step != b.step ? a.step < b.step : a.has_other < b.has_other;
  });
}

GraphFeed::Item GraphFeed::item_of(EdgeRef edge) {
  Id pose = -1, any = -1;
  bool has_other = false;
  for (const VertexRef& vertex : source_.vertices(edge)) {
    if (is_parameter(source_, vertex)) continue;
    detail::Frame frame;
    const bool is_pose =
        source_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame) && frame.has_rotation;
    const Id id = source_.id(vertex);
    any = std::max(any, id);
    if (is_pose) pose = std::max(pose, id);
    has_other = has_other || !is_pose;
  }
  return {pose >= 0 ? pose : any, has_other, edge};
}

bool GraphFeed::step() {
  if (next_ == items_.size()) {
    for (const VertexRef& vertex : source_.all_vertices()) counterpart(vertex);
    return false;
  }
  const Id step = items_[next_].step;
  for (; next_ < items_.size() && items_[next_].step == step; ++next_) copy(items_[next_].edge);
  return true;
}

/// The vertex of the target with the same id; it is added if it is not there yet.
VertexRef GraphFeed::counterpart(VertexRef vertex) {
  const bool parameter = is_parameter(source_, vertex);
  const Id id = source_.id(vertex);
  const std::optional<VertexRef> found = parameter ? target_.find_parameter(id) : target_.find_vertex(id);
  return found ? *found : copy(vertex, parameter);
}

VertexRef GraphFeed::copy(VertexRef vertex, bool parameter) {
  const Tag& tag = tag_of(source_, vertex, source_.vertex_pools()[vertex.pool]->type_name());
  std::string text;
  FieldWriter out(text);
  tag.write_vertex(source_, vertex, out);
  FieldReader in("graph", 1, text);
  const VertexRef added = tag.read_vertex(target_, source_.id(vertex), in);
  target_.set_fixed(added, source_.is_fixed(vertex));
  if (const std::span<const int> held = source_.fixed_directions(vertex); !held.empty())
    target_.fix_directions(added, held);
  for (const detail::Bound& bound : source_.bounds(vertex))
    target_.set_bounds(added, bound.entry, bound.lower, bound.upper);
  if (source_.is_eliminated(vertex)) target_.set_eliminated(added, true);
  if (!parameter && !source_.is_fixed(vertex)) placement_.expect(added);
  return added;
}

void GraphFeed::copy(EdgeRef edge) {
  const detail::EdgePool& pool = *source_.edge_pools()[edge.pool];
  const Tag& tag = tag_of(source_, edge, pool.type_name());
  std::vector<VertexRef> vertices;
  for (const VertexRef& vertex : source_.vertices(edge)) vertices.push_back(counterpart(vertex));
  std::string text;
  FieldWriter out(text);
  tag.write_edge(source_, edge, out);
  FieldReader in("graph", 1, text);
  const EdgeRef added = tag.read_edge(target_, vertices, in);
  if (const RobustKernel* kernel = source_.kernel(edge))  // it lives as long as the source
    target_.set_kernel(added, std::shared_ptr<const RobustKernel>(std::shared_ptr<void>(), kernel));
  if (!source_.is_enabled(edge)) target_.set_enabled(added, false);
  if (source_.level(edge) != 0) target_.set_level(added, source_.level(edge));
  placement_.place_by(added);
}

void GraphFeed::copy_estimates_to(Graph& graph) const {
  const auto copy_all = [&](const std::vector<VertexRef>& vertices, auto&& find) {
    for (const VertexRef& vertex : vertices) {
      const std::optional<VertexRef> from = find(graph.id(vertex));
      if (!from) continue;
      std::unique_ptr<detail::SavedEstimates> saved;
      target_.vertex_pools()[from->pool]->save({&from->slot, 1}, saved);
      graph.vertex_pools()[vertex.pool]->restore({&vertex.slot, 1}, *saved);
    }
  };
  copy_all(graph.all_vertices(), [&](Id id) { return target_.find_vertex(id); });
  copy_all(graph.all_parameters(), [&](Id id) { return target_.find_parameter(id); });
}

}  // namespace boxplus::programs
