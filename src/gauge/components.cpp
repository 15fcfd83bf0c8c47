// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/components.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/paced_stop.h"
#include "graph/weighted_rows.h"

namespace boxplus {

std::vector<Component> ComponentFinder::find(const std::vector<std::vector<std::uint32_t>>& active_edges) {
  PacedStop pace(stop_);
  const auto for_each_edge = [&](auto&& f) {
    for (std::uint32_t p = 0; p < active_edges.size(); ++p) {
      for (const std::uint32_t slot : active_edges[p]) {
        pace.step();
        f(EdgeSlot{p, slot});
      }
    }
  };
  DisjointSets sets(ends_.view().numbers());
  for_each_edge([&](EdgeSlot edge) {
    std::uint32_t last = kNone;
    ends_.for_each_moving(edge, [&](VertexSlot v, std::size_t) {
      if (last != kNone) sets.join(last, ends_.number(v));
      last = ends_.number(v);
    });
  });
  std::vector<Component> result;
  std::vector<std::uint32_t> component_of(ends_.view().numbers(),
                                          kNone);  // the index in `result` of each root
  for_each_edge([&](EdgeSlot edge) {
    std::uint32_t root = kNone;
    int moving = 0;
    ends_.for_each_moving(edge, [&](VertexSlot v, std::size_t) {
      root = sets.find(ends_.number(v));
      ++moving;
    });
    if (moving == 0) return;
    if (component_of[root] == kNone) {
      component_of[root] = static_cast<std::uint32_t>(result.size());
      result.emplace_back();
    }
    add_edge(edge, moving, result[component_of[root]]);
  });
  for (VertexSlot v{0, 0}; v.pool < movable_.size(); ++v.pool) {
    for (v.slot = 0; v.slot < movable_[v.pool].size(); ++v.slot) {
      const std::uint32_t component = component_of[sets.find(ends_.number(v))];
      if (component != kNone) add_vertex(v, result[component]);
    }
  }
  return result;
}

std::vector<std::uint8_t> ComponentFinder::find_shared(const std::vector<Component>& components) const {
  std::vector<std::uint8_t> is_shared(ends_.view().numbers(), 0);
  if (components.size() < 2) return is_shared;
  std::vector<std::uint32_t> first(ends_.view().numbers(), kNone);  // component
  PacedStop pace(stop_);
  for (std::uint32_t c = 0; c < components.size(); ++c) {
    for (const EdgeSlot edge : components[c].edges) {
      pace.step();
      ends_.for_each(edge, [&](VertexSlot v, EdgeEnds::End, std::size_t) {
        const std::uint32_t number = ends_.number(v);
        if (first[number] == kNone) first[number] = c;
        if (first[number] != c) is_shared[number] = 1;
      });
    }
  }
  return is_shared;
}

void ComponentFinder::add_vertex(VertexSlot v, Component& component) const {
  const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
  component.vertices.push_back(v);
  if (!pool.fixed_directions(v.slot).empty()) component.anchored = true;
  if (!pool.bounds(v.slot).empty()) component.bounded = true;
}

void ComponentFinder::add_edge(EdgeSlot edge, int moving, Component& component) const {
  component.edges.push_back(edge);
  const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
  const int rows = pool.shape(edge.slot).rows,
            structural = structural_rows(pool.information(edge.slot, rows));
  component.only_rigid = component.only_rigid && pool.is_rigid() && structural == rows;
  if (moving == 1) component.most_anchor_rows = std::max(component.most_anchor_rows, structural);
  bool anchors = moving == 1;
  ends_.for_each(edge, [&](VertexSlot, EdgeEnds::End end, std::size_t) {
    anchors = anchors || end == EdgeEnds::End::kFixed;
  });
  if (!anchors) return;
  component.anchored = true;
  component.anchors.push_back(edge);
}

void ComponentFinder::number_vertices(const Component& component) {
  local_.resize(ends_.view().numbers());
  for (std::uint32_t k = 0; k < component.vertices.size(); ++k)
    local_[ends_.number(component.vertices[k])] = k;
}
std::vector<Component> ComponentFinder::parts_without(const Component& whole,
                                                      const std::vector<VertexSlot>& left_out) {
  number_vertices(whole);
  for (const VertexSlot v : left_out) local_[ends_.number(v)] = kNone;
  const auto for_each_moving = [&](EdgeSlot edge, auto&& f) {
    ends_.for_each_moving(edge, [&](VertexSlot v, std::size_t) {
      if (local(v) != kNone) f(local(v));
    });
  };
  DisjointSets sets(static_cast<std::uint32_t>(whole.vertices.size()));
  for (const EdgeSlot edge : whole.edges) {
    std::uint32_t last = kNone;
    for_each_moving(edge, [&](std::uint32_t vertex) {
      if (last != kNone) sets.join(last, vertex);
      last = vertex;
    });
  }
  std::vector<Component> parts;
  std::vector<std::uint32_t> part_of(whole.vertices.size(), kNone);  // of each root
  for (const VertexSlot v : whole.vertices) {
    if (local(v) == kNone) continue;
    std::uint32_t& part = part_of[sets.find(local(v))];
    if (part == kNone) {
      part = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    add_vertex(v, parts[part]);
  }
  const auto is_single = [](const Component& part) { return part.vertices.size() == 1; };
  if (parts.size() < 2 || std::ranges::any_of(parts, is_single)) return {};
  if (parts.size() * left_out.size() > whole.vertices.size()) return {};  // would take long
  for (const EdgeSlot edge : whole.edges) {
    std::uint32_t vertex = kNone;
    int moving = 0;
    for_each_moving(edge, [&](std::uint32_t v) { vertex = v; });
    ends_.for_each_moving(edge, [&](VertexSlot, std::size_t) { ++moving; });
    if (vertex != kNone) add_edge(edge, moving, parts[part_of[sets.find(vertex)]]);
  }
  for (Component& part : parts) part.left_out = left_out;
  parts.front().shared = left_out;
  return parts;
}

std::vector<bool> ComponentFinder::find_determined(const Component& component) {
  number_vertices(component);
  for (const VertexSlot v : component.left_out) local_[ends_.number(v)] = kNone;
  std::vector<int> rows(component.vertices.size(), 0);
  for (const EdgeSlot edge : component.edges) {
    const int more = structural_rows(graph_.edge_pools()[edge.pool]->information(edge.slot));
    ends_.for_each_moving(edge, [&](VertexSlot v, std::size_t) {
      if (local(v) != kNone) rows[local(v)] += more;
    });
  }
  std::vector<bool> is_determined;
  for (const VertexSlot v : component.vertices)
    is_determined.push_back(rows[local(v)] >= graph_.vertex_pools()[v.pool]->tangent_dim(v.slot));
  return is_determined;
}

}  // namespace boxplus
