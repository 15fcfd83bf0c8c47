// SPDX-License-Identifier: BSD-3-Clause
#include "plan/active_set.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <unordered_map>

#include "base/paced_stop.h"
#include "plan/fixed_directions.h"

namespace boxplus {
namespace {

/// One flag per slot of every vertex pool.
using Flags = std::vector<std::vector<std::uint8_t>>;

Flags make_flags(const Graph& graph, std::uint8_t value) {
  Flags flags;
  for (const auto& pool : graph.vertex_pools()) flags.emplace_back(pool->slots(), value);
  return flags;
}

/// The vertices that may move: all vertices of the requested subset that are not fixed.
Flags movable_vertices(const Graph& graph, const PlanRequest& request) {
  Flags movable = make_flags(graph, request.vertices.empty());
  for (const VertexRef& vertex : request.vertices) {
    if (!graph.contains(vertex)) throw InvalidArgument("Options::vertices holds a stale vertex handle");
    movable[vertex.pool][vertex.slot] = 1;
  }
  PacedStop pace(request.stop);
  for (std::size_t p = 0; p < movable.size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      pace.step();
      if (!pool.alive(slot) || pool.fixed(slot) || all_directions_fixed(pool, slot)) movable[p][slot] = 0;
    }
  }
  return movable;
}

/// A number whose bits depend on all bits of `x` (the finalizer of SplitMix64; Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", 2014).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

template <class F>
void for_each_vertex(const detail::EdgePool& pool, std::uint32_t edge, F&& f) {
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) f(pool.vertex_pool(edge, static_cast<int>(i)), slots[i]);
}

/// The active edges. If a subset of vertices was requested, these are the requested edges that touch a vertex
/// that may move. Otherwise, these are all requested edges.
std::vector<std::vector<std::uint32_t>> active_edges(const Graph& graph, const PlanRequest& request,
                                                     const Flags& movable) {
  std::vector<std::vector<std::uint8_t>> wanted;
  for (const auto& pool : graph.edge_pools()) wanted.emplace_back(pool->slots(), request.edges.empty());
  for (const EdgeRef& edge : request.edges) {
    if (!graph.contains(edge)) throw InvalidArgument("Options::edges holds a stale edge handle");
    wanted[edge.pool][edge.slot] = 1;
  }
  PacedStop pace(request.stop);
  std::vector<std::vector<std::uint32_t>> result(graph.edge_pools().size());
  for (std::size_t p = 0; p < result.size(); ++p) {
    const detail::EdgePool& pool = *graph.edge_pools()[p];
    for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
      pace.step();
      if (!pool.alive(edge) || !wanted[p][edge]) continue;
      if (request.level >= 0 && pool.level(edge) != request.level) continue;
      bool touches = request.vertices.empty();
      for_each_vertex(pool, edge,
                      [&](std::uint32_t v, std::uint32_t slot) { touches |= movable[v][slot] != 0; });
      if (touches) result[p].push_back(edge);
    }
  }
  return result;
}

std::vector<VertexRef> touched_vertices(const Graph& graph, const ActiveSet& active, const Flags& movable,
                                        const StopToken& stop) {
  PacedStop pace(stop);
  Flags seen = make_flags(graph, 0);
  for (std::size_t p = 0; p < active.edges.size(); ++p) {
    for (std::uint32_t edge : active.edges[p]) {
      pace.step();
      for_each_vertex(*graph.edge_pools()[p], edge,
                      [&](std::uint32_t v, std::uint32_t slot) { seen[v][slot] = 1; });
    }
  }
  std::vector<VertexRef> result;
  for (std::uint32_t p = 0; p < seen.size(); ++p) {
    for (std::uint32_t slot = 0; slot < seen[p].size(); ++slot) {
      pace.step();
      if (seen[p][slot] && movable[p][slot])
        result.push_back({p, slot, graph.vertex_pools()[p]->generation(slot)});
    }
  }
  return result;
}

/// Moves each kept vertex behind the first of those that share edges with exactly the same eliminated
/// vertices, such as a camera behind the pose that alone uses it, because a Schur complement can join their
/// blocks. Two sets of eliminated vertices count as the same if their checksums are; a mistake is harmless.
void gather_kept_vertices(const Graph& graph, const ActiveSet& active, std::span<VertexRef> kept,
                          PacedStop& pace) {
  const auto is_eliminated = [&](std::uint32_t v, std::uint32_t slot) {
    return graph.vertex_pools()[v]->eliminated(slot);
  };
  std::vector<std::vector<std::uint64_t>> checksum;
  for (const auto& pool : graph.vertex_pools()) checksum.emplace_back(pool->slots(), 0);
  for (std::size_t p = 0; p < active.edges.size(); ++p) {
    const detail::EdgePool& pool = *graph.edge_pools()[p];
    for (const std::uint32_t edge : active.edges[p]) {
      pace.step();
      std::uint64_t sum = 0;
      for_each_vertex(pool, edge, [&](std::uint32_t v, std::uint32_t slot) {
        if (is_eliminated(v, slot)) sum += mixed((std::uint64_t{v} << 32) + slot + 1);
      });
      if (sum == 0) continue;
      for_each_vertex(pool, edge, [&](std::uint32_t v, std::uint32_t slot) { checksum[v][slot] += sum; });
    }
  }
  std::unordered_map<std::uint64_t, std::size_t> first_with;
  std::vector<std::pair<std::size_t, VertexRef>> placed;  // each vertex, with the place of its first partner
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::uint64_t sum = checksum[kept[k].pool][kept[k].slot];
    placed.emplace_back(sum == 0 ? k : first_with.try_emplace(sum, k).first->second, kept[k]);
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = placed[k].second;
}

/// Numbers the blocks. Eliminated vertices come first, then all others. Both groups are sorted by id, and a
/// parameter comes after a vertex with the same id; then kept vertices of several types are gathered.
void number_blocks(const Graph& graph, std::vector<VertexRef> vertices, ActiveSet& active,
                   const StopToken& stop) {
  PacedStop pace(stop);
  const auto rank = [&](const VertexRef& v) {
    const detail::VertexPool& pool = *graph.vertex_pools()[v.pool];
    return std::tuple(!pool.eliminated(v.slot), pool.id(v.slot), pool.parameter(v.slot));
  };
  const auto comes_before = [&](const VertexRef& a, const VertexRef& b) {
    pace.step();
    return rank(a) < rank(b);
  };
  // Most graphs add their vertices in the order of their ids, so that this is all there is to sort.
  std::stable_partition(vertices.begin(), vertices.end(),
                        [&](const VertexRef& v) { return graph.vertex_pools()[v.pool]->eliminated(v.slot); });
  if (!std::is_sorted(vertices.begin(), vertices.end(), comes_before))
    std::sort(vertices.begin(), vertices.end(), comes_before);
  const auto first_kept = std::partition_point(vertices.begin(), vertices.end(), [&](const VertexRef& v) {
    return graph.vertex_pools()[v.pool]->eliminated(v.slot);
  });
  const bool has_types =
      std::any_of(first_kept, vertices.end(), [&](const VertexRef& v) { return v.pool != first_kept->pool; });
  if (first_kept != vertices.begin() && has_types)
    gather_kept_vertices(graph, active, std::span(first_kept, vertices.end()), pace);
  for (const auto& pool : graph.vertex_pools())
    active.block.emplace_back(pool->slots(), ActiveSet::kInactive);
  for (const VertexRef& vertex : vertices) {
    pace.step();
    active.block[vertex.pool][vertex.slot] = static_cast<std::uint32_t>(active.block_vertex.size());
    active.block_vertex.push_back(vertex);
    active.eliminated_blocks += graph.vertex_pools()[vertex.pool]->eliminated(vertex.slot);
  }
}

}  // namespace

ActiveSet find_active_set(const Graph& graph, const PlanRequest& request) {
  return find_active_set(graph, request, GaugeBounds::kApply);
}

ActiveSet find_active_set(const Graph& graph, const PlanRequest& request, GaugeBounds bounds) {
  ActiveSet active;
  Flags movable = movable_vertices(graph, request);
  active.edges = active_edges(graph, request, movable);
  std::vector<VertexRef> vertices = touched_vertices(graph, active, movable, request.stop);
  active.gauge = find_gauge(graph, active.edges, movable, request.gauge, request.stop, bounds);
  for (const detail::GaugeVertex& held : active.gauge.held) std::erase(vertices, held.vertex);
  number_blocks(graph, std::move(vertices), active, request.stop);
  return active;
}

}  // namespace boxplus
