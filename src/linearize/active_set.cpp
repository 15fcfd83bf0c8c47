// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/active_set.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

namespace boxplus {
namespace {

/// One flag per slot of every vertex pool.
using Flags = std::vector<std::vector<std::uint8_t>>;

Flags make_flags(const Graph& graph, std::uint8_t value) {
  Flags flags;
  for (const auto& pool : graph.vertex_pools()) flags.emplace_back(pool->slots(), value);
  return flags;
}

/// Vertices that may move: neither fixed nor outside of the requested subset.
Flags movable_vertices(const Graph& graph, const PlanRequest& request) {
  Flags movable = make_flags(graph, request.vertices.empty());
  for (const VertexRef& vertex : request.vertices) {
    if (!graph.contains(vertex)) throw InvalidArgument("Options::vertices holds a stale vertex handle");
    movable[vertex.pool][vertex.slot] = 1;
  }
  for (std::size_t p = 0; p < movable.size(); ++p) {
    const VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (!pool.alive(slot) || pool.fixed(slot) || pool.tangent_dim(slot) == 0) movable[p][slot] = 0;
    }
  }
  return movable;
}

template <class F>
void for_each_vertex(const EdgePool& pool, std::uint32_t edge, F&& f) {
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) f(pool.vertex_pool(static_cast<int>(i)), slots[i]);
}

/// Active edges touch a vertex that may move, or are evaluated all the same where no subset was asked for.
std::vector<std::vector<std::uint32_t>> active_edges(const Graph& graph, const PlanRequest& request,
                                                     const Flags& movable) {
  std::vector<std::vector<std::uint8_t>> wanted;
  for (const auto& pool : graph.edge_pools()) wanted.emplace_back(pool->slots(), request.edges.empty());
  for (const EdgeRef& edge : request.edges) {
    if (!graph.contains(edge)) throw InvalidArgument("Options::edges holds a stale edge handle");
    wanted[edge.pool][edge.slot] = 1;
  }
  std::vector<std::vector<std::uint32_t>> result(graph.edge_pools().size());
  for (std::size_t p = 0; p < result.size(); ++p) {
    const EdgePool& pool = *graph.edge_pools()[p];
    for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
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

/// Disjoint sets with path halving (Tarjan & van Leeuwen, 1984).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Finds the components that nothing holds in place, and the vertex to hold in each.
///
/// An edge anchors a component with its rows where exactly one of its vertices is free (a prior, a
/// measurement against a fixed vertex). Parameters count neither as free nor as fixed vertices.
class GaugeFinder {
 public:
  GaugeFinder(const Graph& graph, const ActiveSet& active, const Flags& movable)
      : graph_(graph), movable_(movable) {
    std::size_t count = 0;
    for (const auto& pool : graph.vertex_pools()) {
      first_.push_back(count);
      count += pool->slots();
    }
    sets_ = DisjointSets(count);
    anchor_rows_.assign(count, 0);
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t p = 0; p < active.edges.size(); ++p) {
        for (std::uint32_t edge : active.edges[p]) visit(*graph.edge_pools()[p], edge, pass == 1);
      }
    }
  }

  /// Per component without enough anchors: its rows of anchors and the vertex to hold.
  void find(const std::vector<VertexRef>& active_vertices, const PlanRequest& request, ActiveSet& out) {
    struct Candidate {
      VertexRef vertex;
      std::tuple<int, int, Id> rank;  // larger dimension first, then poses, then points, then lower id
      int dim = 0;
      bool known = false;
    };
    std::vector<Candidate> candidates(anchor_rows_.size());
    std::vector<std::uint32_t> roots;
    for (const VertexRef& vertex : active_vertices) {
      const VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
      if (pool.parameter(vertex.slot)) continue;
      const std::uint32_t root = sets_.find(index(vertex.pool, vertex.slot));
      Frame frame;
      const int dim = pool.tangent_dim(vertex.slot);
      const bool has_frame = pool.get_frame(vertex.slot, frame);
      const std::tuple rank{-dim, has_frame ? (frame.has_rotation ? 0 : 1) : 2, pool.id(vertex.slot)};
      Candidate& best = candidates[root];
      if (!best.known) roots.push_back(root);
      if (!best.known || rank < best.rank) best = {vertex, rank, dim, true};
    }
    for (std::uint32_t root : roots) {
      const Candidate& candidate = candidates[root];
      const int rows = anchor_rows_[root];
      if (rows >= candidate.dim) continue;
      if (rows > 0) {
        ++out.damped_components;
      } else if (request.gauge == GaugePolicy::kFixFirst) {
        const bool refused = std::find(request.never_hold.begin(), request.never_hold.end(),
                                       candidate.vertex) != request.never_hold.end();
        if (!refused) out.held.push_back({candidate.vertex, std::get<2>(candidate.rank), {}});
      } else {
        ++out.free_components;
      }
    }
  }

 private:
  std::uint32_t index(std::uint32_t pool, std::uint32_t slot) const {
    return static_cast<std::uint32_t>(first_[pool] + slot);
  }

  void visit(const EdgePool& pool, std::uint32_t edge, bool count_anchors) {
    int free = 0;
    std::uint32_t last = 0;
    for_each_vertex(pool, edge, [&](std::uint32_t v, std::uint32_t slot) {
      if (!movable_[v][slot] || graph_.vertex_pools()[v]->parameter(slot)) return;
      const std::uint32_t node = index(v, slot);
      if (!count_anchors && free > 0) sets_.join(last, node);
      last = node;
      ++free;
    });
    if (count_anchors && free == 1) anchor_rows_[sets_.find(last)] += pool.shape(edge).rows;
  }

  const Graph& graph_;
  const Flags& movable_;
  std::vector<std::size_t> first_;
  DisjointSets sets_{0};
  std::vector<int> anchor_rows_;
};

std::vector<VertexRef> touched_vertices(const Graph& graph, const ActiveSet& active, const Flags& movable) {
  Flags seen = make_flags(graph, 0);
  for (std::size_t p = 0; p < active.edges.size(); ++p) {
    for (std::uint32_t edge : active.edges[p]) {
      for_each_vertex(*graph.edge_pools()[p], edge,
                      [&](std::uint32_t v, std::uint32_t slot) { seen[v][slot] = 1; });
    }
  }
  std::vector<VertexRef> result;
  for (std::uint32_t p = 0; p < seen.size(); ++p) {
    for (std::uint32_t slot = 0; slot < seen[p].size(); ++slot) {
      if (seen[p][slot] && movable[p][slot])
        result.push_back({p, slot, graph.vertex_pools()[p]->generation(slot)});
    }
  }
  return result;
}

/// Blocks: eliminated vertices first, then the others, each group by id (parameters after vertices of the
/// same id).
void number_blocks(const Graph& graph, std::vector<VertexRef> vertices, ActiveSet& active) {
  const auto rank = [&](const VertexRef& v) {
    const VertexPool& pool = *graph.vertex_pools()[v.pool];
    return std::tuple(!pool.eliminated(v.slot), pool.id(v.slot), pool.parameter(v.slot));
  };
  std::sort(vertices.begin(), vertices.end(),
            [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  for (const auto& pool : graph.vertex_pools())
    active.block.emplace_back(pool->slots(), ActiveSet::kInactive);
  for (const VertexRef& vertex : vertices) {
    active.block[vertex.pool][vertex.slot] = static_cast<std::uint32_t>(active.block_vertex.size());
    active.block_vertex.push_back(vertex);
    active.eliminated_blocks += graph.vertex_pools()[vertex.pool]->eliminated(vertex.slot);
  }
}

void list_uses(const Graph& graph, ActiveSet& active) {
  if (active.held.empty()) return;
  for (std::uint32_t p = 0; p < active.edges.size(); ++p) {
    const EdgePool& pool = *graph.edge_pools()[p];
    for (std::uint32_t edge : active.edges[p]) {
      std::uint32_t position = 0;
      for_each_vertex(pool, edge, [&](std::uint32_t v, std::uint32_t slot) {
        for (GaugeVertex& gauge : active.held) {
          if (gauge.vertex.pool == v && gauge.vertex.slot == slot) gauge.uses.push_back({p, edge, position});
        }
        ++position;
      });
    }
  }
}

}  // namespace

ActiveSet find_active_set(const Graph& graph, const PlanRequest& request) {
  ActiveSet active;
  Flags movable = movable_vertices(graph, request);
  active.edges = active_edges(graph, request, movable);
  std::vector<VertexRef> vertices = touched_vertices(graph, active, movable);
  GaugeFinder(graph, active, movable).find(vertices, request, active);
  for (const GaugeVertex& gauge : active.held) std::erase(vertices, gauge.vertex);
  list_uses(graph, active);
  number_blocks(graph, std::move(vertices), active);
  return active;
}

}  // namespace boxplus
