// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/gauge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <tuple>

#include "base/disjoint_sets.h"
#include "base/paced_stop.h"
#include "gauge/similarity_freedom.h"
#include "gauge/subspace.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

/// A connected component: moving vertices, and the edges that join them.
struct Component {
  std::vector<VertexSlot> vertices;
  std::vector<EdgeSlot> edges;
  int most_anchor_rows = 0;  // the most rows of an edge with exactly one moving vertex
  bool anchored = false;     // whether an edge or a fixed direction ties a vertex to the world
  bool only_rigid = true;    // whether all edges are of types that measure poses relative to each other
};

/// Finds the moving vertices of an edge. Parameters count neither as moving nor as fixed.
class EdgeEnds {
 public:
  EdgeEnds(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable) : graph_(graph) {
    for (std::size_t p = 0; p < movable.size(); ++p) {
      const detail::VertexPool& pool = *graph.vertex_pools()[p];
      std::vector<End>& ends = ends_.emplace_back(movable[p].size());
      for (std::uint32_t slot = 0; slot < ends.size(); ++slot) {
        ends[slot] = pool.parameter(slot)    ? End::kParameter
                     : movable[p][slot] != 0 ? End::kMoving
                                             : End::kFixed;
      }
    }
  }

  template <class F>
  void for_each_moving(EdgeSlot edge, F&& f) const {
    for_each(edge, [&](VertexSlot v, End end) {
      if (end == End::kMoving) f(v);
    });
  }
  bool has_fixed(EdgeSlot edge) const {
    bool result = false;
    for_each(edge, [&](VertexSlot, End end) { result |= end == End::kFixed; });
    return result;
  }

 private:
  enum class End : std::uint8_t { kParameter, kFixed, kMoving };

  template <class F>
  void for_each(EdgeSlot edge, F&& f) const {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    const auto slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
      f(VertexSlot{p, slots[i]}, ends_[p][slots[i]]);
    }
  }

  const Graph& graph_;
  std::vector<std::vector<End>> ends_;  // per slot of each vertex pool
};

class GaugeFinder {
 public:
  GaugeFinder(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable, GaugePolicy policy,
              const StopToken& stop)
      : graph_(graph), movable_(movable), ends_(graph, movable), policy_(policy), stop_(stop) {}

  Gauge find(const std::vector<std::vector<std::uint32_t>>& active_edges) {
    for (Component& component : components(active_edges)) {
      gauge_.components.emplace_back().anchored = component.anchored;
      decide(component);
      gauge_.components.back().vertices = std::move(component.vertices);
    }
    return std::move(gauge_);
  }

 private:
  std::vector<Component> components(const std::vector<std::vector<std::uint32_t>>& active_edges) const {
    std::vector<std::size_t> first;
    std::size_t count = 0;
    for (const auto& pool : graph_.vertex_pools()) {
      first.push_back(count);
      count += pool->slots();
    }
    const auto index = [&](VertexSlot v) { return static_cast<std::uint32_t>(first[v.pool] + v.slot); };
    PacedStop pace(stop_);
    const auto for_each_edge = [&](auto&& f) {
      for (std::uint32_t p = 0; p < active_edges.size(); ++p) {
        for (const std::uint32_t slot : active_edges[p]) {
          pace.step();
          f(EdgeSlot{p, slot});
        }
      }
    };
    constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    DisjointSets sets(count);
    for_each_edge([&](EdgeSlot edge) {
      std::uint32_t last = kNone;
      ends_.for_each_moving(edge, [&](VertexSlot v) {
        if (last != kNone) sets.join(last, index(v));
        last = index(v);
      });
    });
    std::vector<Component> result;
    std::vector<std::uint32_t> component_of(count, kNone);  // the index in `result` of each root
    std::vector<std::uint8_t> seen(count, 0);
    for_each_edge([&](EdgeSlot edge) {
      std::uint32_t root = kNone;
      int moving = 0;
      ends_.for_each_moving(edge, [&](VertexSlot v) {
        root = sets.find(index(v));
        ++moving;
        if (component_of[root] == kNone) {
          component_of[root] = static_cast<std::uint32_t>(result.size());
          result.emplace_back();
        }
        if (!seen[index(v)]) add_vertex(v, result[component_of[root]]);
        seen[index(v)] = 1;
      });
      if (moving > 0) add_edge(edge, moving, result[component_of[root]]);
    });
    return result;
  }

  void add_vertex(VertexSlot v, Component& component) const {
    component.vertices.push_back(v);
    if (graph_.vertex_pools()[v.pool]->fixed_directions(v.slot).empty()) return;
    component.anchored = true;
    component.only_rigid = false;
  }

  void add_edge(EdgeSlot edge, int moving, Component& component) const {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    component.edges.push_back(edge);
    component.only_rigid = component.only_rigid && pool.is_rigid();
    component.anchored = component.anchored || moving == 1 || ends_.has_fixed(edge);
    if (moving == 1)
      component.most_anchor_rows = std::max(component.most_anchor_rows, pool.shape(edge.slot).rows);
  }

  VertexRef reference(VertexSlot v) const {
    return {v.pool, v.slot, graph_.vertex_pools()[v.pool]->generation(v.slot)};
  }

  /// The rank of a vertex. The vertex with the lowest rank is held fixed. Vertices are ranked by dimension
  /// (the largest first), then by kind (poses, points, others), then by id. Eliminated vertices come last.
  auto rank(VertexSlot v) const {
    const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
    detail::Frame frame;
    const bool has_frame = pool.get_frame(v.slot, frame);
    return std::tuple(pool.eliminated(v.slot), -pool.tangent_dim(v.slot),
                      has_frame ? (frame.has_rotation ? 0 : 1) : 2, pool.id(v.slot));
  }

  /// Whether v has a lower rank than w, which is of the same pool, so of the same kind.
  bool comes_before(VertexSlot v, VertexSlot w) const {
    const detail::VertexPool& pool = *graph_.vertex_pools()[v.pool];
    const auto rank_in_pool = [&](VertexSlot u) {
      return std::tuple(pool.eliminated(u.slot), -pool.tangent_dim(u.slot), pool.id(u.slot));
    };
    return rank_in_pool(v) < rank_in_pool(w);
  }

  VertexSlot first_choice(std::span<const VertexSlot> vertices) const {
    return *std::min_element(vertices.begin(), vertices.end(),
                             [&](VertexSlot a, VertexSlot b) { return rank(a) < rank(b); });
  }

  void decide(const Component& component) {
    if (component.only_rigid) {
      const VertexSlot first = first_choice(component.vertices);
      const int dim = graph_.vertex_pools()[first.pool]->tangent_dim(first.slot);
      if (component.most_anchor_rows >= dim) return;
      if (!component.anchored) return hold_rigid(first, dim);
    }
    bool is_known = false;
    for (const int dimension : {2, 3}) {
      if (!has_frames(component, dimension)) continue;
      if (!test_) test_ = std::make_unique<SimilarityTest>(graph_, movable_, stop_);
      const SimilarityFreedom freedom = freedom_of(component, dimension);
      is_known = is_known || freedom.directions() > 0;
      if (freedom.directions() > 0) hold_similarity(component, freedom);
    }
    if (!component.anchored && !is_known) gauge_.loose.push_back(reference(first_choice(component.vertices)));
  }

  /// The freedom of a component. If only directions are held, every step checks whether they are still free,
  /// so a sample of the edges is enough. A vertex that is held as a whole takes part in no step.
  SimilarityFreedom freedom_of(const Component& component, int dimension) {
    const auto find = [&](SimilarityTest::Extent extent) {
      return test_->find(component.vertices, component.edges, dimension, extent);
    };
    if (policy_ != GaugePolicy::kFixFirst) return find(SimilarityTest::Extent::kAllEdges);
    SimilarityFreedom freedom = find(SimilarityTest::Extent::kSample);
    if (freedom.directions() == 0 || !holds_whole(component, gauge_vertex(component, freedom), freedom))
      return freedom;
    return find(SimilarityTest::Extent::kAllEdges);
  }

  bool holds_whole(const Component& component, VertexSlot first, const SimilarityFreedom& freedom) const {
    return !component.anchored && is_all_gauge(first, freedom);
  }

  bool has_frames(const Component& component, int dimension) const {
    std::vector<bool> seen(graph_.vertex_pools().size(), false);  // the vertices of a pool have one type
    return std::any_of(component.vertices.begin(), component.vertices.end(), [&](VertexSlot v) {
      if (seen[v.pool]) return false;
      seen[v.pool] = true;
      detail::Frame frame;
      return graph_.vertex_pools()[v.pool]->get_frame(v.slot, frame) && frame.dimension == dimension;
    });
  }

  /// Handles a component that has only relative poses. All directions of its pose `first` are gauge freedom.
  void hold_rigid(VertexSlot first, int dim) {
    const Id id = graph_.vertex_pools()[first.pool]->id(first.slot);
    detail::Frame frame;
    if (graph_.vertex_pools()[first.pool]->get_frame(first.slot, frame)) {
      gauge_.components.back().free = {all_rigid_motions(frame.dimension)};
    } else {
      gauge_.components.back().free = {{.count = dim}};
    }
    if (policy_ == GaugePolicy::kFixFirst) {
      gauge_.held.push_back({reference(first), id});
    } else {
      gauge_.freedoms.push_back({reference(first), id, dim, true, true, false});
    }
  }

  void hold_similarity(const Component& component, const SimilarityFreedom& freedom) {
    const VertexSlot first = gauge_vertex(component, freedom);
    const Id id = graph_.vertex_pools()[first.pool]->id(first.slot);
    SimilarityFreedom left = freedom;  // the freedom that remains
    note_motions(component, freedom);
    if (policy_ == GaugePolicy::kFixFirst) {
      const bool whole = holds_whole(component, first, freedom);
      if (whole) {
        gauge_.held.push_back({reference(first), id});
        left.keep(kernel_of(freedom.of_vertex(graph_, first), kNoticeable * freedom.unit()));
      }
      hold_directions(component, first, whole, left);
    }
    if (left.directions() > 0) gauge_.freedoms.push_back(describe(first, left));
  }

  void note_motions(const Component& component, const SimilarityFreedom& freedom) {
    GaugeComponent& noted = gauge_.components.back();
    const auto& candidates = noted.free.empty() ? component.vertices : noted.still;
    std::vector<VertexSlot> still;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(still),
                 [&](VertexSlot v) { return (*freedom.roles)[v.pool][v.slot] == WorldRole::kNone; });
    noted.free.push_back(free_motions_of(freedom));
    noted.still = std::move(still);
  }

  int taken_by(VertexSlot v, const SimilarityFreedom& freedom) const {
    const MatrixXd own = freedom.of_vertex(graph_, v);
    return freedom.directions() - static_cast<int>(kernel_of(own, kNoticeable * freedom.unit()).cols());
  }
  bool is_all_gauge(VertexSlot v, const SimilarityFreedom& freedom) const {
    return taken_by(v, freedom) == graph_.vertex_pools()[v.pool]->tangent_dim(v.slot);
  }

  /// The vertex that removes most of the gauge freedom if it is held. Among several such vertices, prefers a
  /// vertex whose directions are all gauge freedom.
  VertexSlot gauge_vertex(const Component& component, const SimilarityFreedom& freedom) const {
    const auto role = [&](VertexSlot v) { return (*freedom.roles)[v.pool][v.slot]; };
    std::vector<VertexSlot> firsts;  // the vertex with the lowest rank of each vertex pool and role
    for (const VertexSlot v : component.vertices) {
      const auto same = std::find_if(firsts.begin(), firsts.end(),
                                     [&](VertexSlot f) { return f.pool == v.pool && role(f) == role(v); });
      if (same == firsts.end()) {
        firsts.push_back(v);
      } else if (comes_before(v, *same)) {
        *same = v;
      }
    }
    const auto order = [&](VertexSlot v) {
      return std::tuple(-taken_by(v, freedom), !is_all_gauge(v, freedom), rank(v));
    };
    return *std::min_element(firsts.begin(), firsts.end(),
                             [&](VertexSlot a, VertexSlot b) { return order(a) < order(b); });
  }

  /// Holds as many tangent directions as there are free motions, preferably directions of `first`. Every free
  /// motion changes at least one held direction. So there is an exact Gauss-Newton step that is zero in all
  /// held directions.
  void hold_directions(const Component& component, VertexSlot first, bool first_is_held,
                       SimilarityFreedom left) {
    const auto row_norms = [&](VertexSlot v) -> Eigen::VectorXd {
      return left.of_vertex(graph_, v).rowwise().norm();
    };
    const auto hold = [&](VertexSlot v) {
      Eigen::Index row = 0;
      row_norms(v).maxCoeff(&row);
      gauge_.held_directions.push_back({reference(v), static_cast<int>(row)});
      left.keep(kernel_of(left.of_vertex(graph_, v).row(row), kNoticeable * left.unit()));
    };
    const auto may_hold = [&](VertexSlot v) {
      return graph_.vertex_pools()[v.pool]->tangent_dim(v.slot) > 0 &&
             !graph_.vertex_pools()[v.pool]->eliminated(v.slot) &&
             !(first_is_held && v.pool == first.pool && v.slot == first.slot);
    };
    while (left.directions() > 0) {
      const int before = left.directions();
      VertexSlot best = first;
      double most = may_hold(first) ? row_norms(first).maxCoeff() : 0;
      if (most <= kNoticeable * left.unit()) {
        for (const VertexSlot v : component.vertices) {
          const double size = may_hold(v) ? row_norms(v).maxCoeff() : 0;
          if (size > most) std::tie(most, best) = std::tuple(size, v);
        }
      }
      if (most > 0) hold(best);
      if (left.directions() == before) return;
    }
  }

  detail::GaugeFreedom describe(VertexSlot vertex, const SimilarityFreedom& left) const {
    const FreeMotions motions = free_motions_of(left);
    const Id id = graph_.vertex_pools()[vertex.pool]->id(vertex.slot);
    return {reference(vertex),      id,           motions.count, !motions.along.empty(),
            !motions.about.empty(), motions.scale};
  }

  /// A fraction of the unit of a motion. Values below this fraction are rounding errors.
  static constexpr double kNoticeable = 1e-5;

  const Graph& graph_;
  const std::vector<std::vector<std::uint8_t>>& movable_;
  EdgeEnds ends_;
  GaugePolicy policy_;
  const StopToken& stop_;
  std::unique_ptr<SimilarityTest> test_;
  Gauge gauge_;
};

}  // namespace

std::string_view detail::to_string(const detail::GaugeFreedom& freedom) {
  if (freedom.translation && freedom.rotation)
    return freedom.scale ? "translation, rotation and scale" : "translation and rotation";
  if (freedom.translation) return freedom.scale ? "translation and scale" : "translation";
  if (freedom.rotation) return freedom.scale ? "rotation and scale" : "rotation";
  return "scale";
}

Gauge find_gauge(const Graph& graph, const std::vector<std::vector<std::uint32_t>>& active_edges,
                 const std::vector<std::vector<std::uint8_t>>& movable, GaugePolicy policy,
                 const StopToken& stop) {
  return GaugeFinder(graph, movable, policy, stop).find(active_edges);
}

}  // namespace boxplus
