// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/gauge.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "gauge/edge_ends.h"
#include "gauge/similarity_freedom.h"
#include "gauge/subspace.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

/// A fraction of the unit of a motion. Values below this fraction are rounding errors.
constexpr double kNoticeable = 1e-5;

class GaugeFinder {
 public:
  GaugeFinder(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable, GaugePolicy policy,
              GaugeBounds bounds, const StopToken& stop)
      : graph_(graph),
        movable_(movable),
        ends_(graph, movable),
        policy_(policy),
        bounds_(bounds),
        stop_(stop),
        components_(graph, movable, ends_, stop) {}

  Gauge find(const std::vector<std::vector<std::uint32_t>>& active_edges) {
    std::vector<Component> components = components_.find(active_edges);
    is_shared_ = components_.find_shared(components);
    for (Component& component : components) {
      for (Component& part : parts_of(std::move(component))) {
        decide(part);
        part.vertices.insert(part.vertices.end(), part.shared.begin(), part.shared.end());
        gauge_.components.push_back(std::move(part));
      }
    }
    return std::move(gauge_);
  }

 private:
  /// Whether to hold vertices or directions of a component. If a vertex has bounds, the world cannot move
  /// freely, although this changes no error: the motions are damped, so that the vertices stay within theirs.
  bool holds(const Component& component) const {
    return policy_ == GaugePolicy::kFixFirst && !(component.bounded && bounds_ == GaugeBounds::kApply);
  }

  const detail::VertexPool& pool_of(VertexSlot v) const { return *graph_.vertex_pools()[v.pool]; }
  VertexRef reference(VertexSlot v) const { return {v.pool, v.slot, pool_of(v).generation(v.slot)}; }

  /// The rank of a vertex. The vertex with the lowest rank is held fixed. Vertices are ranked by dimension
  /// (the largest first), then by kind (poses, points, others), then by id. Eliminated vertices come last.
  auto rank(VertexSlot v) const {
    const detail::VertexPool& pool = pool_of(v);
    detail::Frame frame;
    const bool has_frame = pool.get_frame(v.slot, frame);
    return std::tuple(pool.eliminated(v.slot), -pool.tangent_dim(v.slot),
                      has_frame ? (frame.has_rotation ? 0 : 1) : 2, pool.id(v.slot));
  }

  template <class Order>
  static VertexSlot first_by(std::span<const VertexSlot> vertices, Order&& order) {
    return *std::min_element(vertices.begin(), vertices.end(),
                             [&](VertexSlot a, VertexSlot b) { return order(a) < order(b); });
  }

  VertexSlot first_choice(const Component& component) const {
    return first_by(component.vertices, [this](VertexSlot v) { return rank(v); });
  }

  bool is_rigid(const Component& component) const {
    detail::Frame frame;
    const VertexSlot any = component.vertices.front();
    return component.only_rigid && pool_of(any).get_frame(any.slot, frame);
  }

  void select(const Component& component) {
    is_selected_ = false;
    if (!test_) test_ = std::make_unique<SimilarityTest>(graph_, movable_, ends_, is_shared_, stop_);
    test_->select(component.vertices, component.edges, component.anchors, component.left_out);
  }

  /// If the vertices that do not move with the world join parts that can move by themselves, returns these
  /// parts. Which vertices these are shows in how many motions are free without them. A single vertex is no
  /// part, because its motions may be free for lack of edges: a point that one camera sees may move towards
  /// it.
  std::vector<Component> parts_of(Component whole) {
    std::vector<std::vector<Component>> choices;
    if (!is_rigid(whole)) {
      for (const std::vector<VertexSlot>& left_out : possibly_shared(whole)) {
        std::vector<Component> parts = components_.parts_without(whole, left_out);
        if (!parts.empty()) choices.push_back(std::move(parts));
      }
    }
    std::vector<Component> best;
    best.push_back(std::move(whole));
    bool moves_rigidly = false;
    int most = choices.empty() ? 0 : free_motions(best.front(), moves_rigidly);
    for (std::vector<Component>& parts : choices) {
      const int motions = free_motions_of_parts(parts);
      if (motions > most) best = std::move(parts);
      most = std::max(most, motions);
    }
    return best;
  }

  /// The number of motions that are free in a component in all dimensions of the world. `moves_rigidly` gets
  /// whether all rigid motions of a world are.
  int free_motions(const Component& component, bool& moves_rigidly) {
    int motions = 0;
    moves_rigidly = false;
    select(component);
    for (const int dimension : {2, 3}) {
      const int free = test_->find(dimension, SimilarityTest::Extent::kAllEdges).directions();
      moves_rigidly = moves_rigidly || free >= all_rigid_motions(dimension).count;
      motions += free;
    }
    return motions;
  }

  /// The same for parts of a component; 0 if not all rigid motions are free in one without an anchor. Then
  /// the vertices that the parts share are in the world, such as beacons.
  int free_motions_of_parts(std::span<const Component> parts) {
    int motions = 0;
    for (const Component& part : parts) {
      bool moves_rigidly = false;
      motions += free_motions(part, moves_rigidly);
      if (!part.anchored && !moves_rigidly) return 0;
    }
    return motions;
  }

  /// Sets of vertices that may not move with the world: those without a frame, and these together with those
  /// of another kind that has few, unless there are many such kinds.
  std::vector<std::vector<VertexSlot>> possibly_shared(const Component& component) {
    constexpr std::size_t kFew = 8, kMostSets = 4;
    select(component);
    std::vector<VertexSlot> without_frame;
    std::map<std::uint32_t, std::vector<VertexSlot>> with_frame;  // of each kind, at most kFew + 1
    for (const VertexSlot v : component.vertices) {
      detail::Frame frame;
      const bool has_frame = pool_of(v).get_frame(v.slot, frame);
      std::vector<VertexSlot>& list = has_frame ? with_frame[test_->kind(v)] : without_frame;
      if (!has_frame || list.size() <= kFew) list.push_back(v);
    }
    std::vector<std::vector<VertexSlot>> sets;
    for (auto& [kind, list] : with_frame) {
      if (list.size() > kFew || with_frame.size() == 1) continue;
      list.insert(list.end(), without_frame.begin(), without_frame.end());
      sets.push_back(std::move(list));
    }
    if (sets.size() > kMostSets) sets.clear();  // each costs time
    is_selected_ = true;
    if (!without_frame.empty() && !with_frame.empty()) sets.push_back(std::move(without_frame));
    return sets;
  }

  void decide(Component& component) {
    if (is_rigid(component)) {
      const VertexSlot first = first_choice(component);
      detail::Frame frame;
      pool_of(first).get_frame(first.slot, frame);
      if (component.most_anchor_rows >= pool_of(first).tangent_dim(first.slot)) return;
      if (!component.anchored) return hold_rigid(component, first, frame.dimension);
    }
    if (!std::exchange(is_selected_, false)) select(component);
    const std::size_t held = gauge_.held.size(), held_directions = gauge_.held_directions.size();
    for (const int dimension : {2, 3}) {
      SimilarityFreedom freedom = freedom_of(component, dimension);
      leave_out_held(freedom, held, held_directions);
      if (freedom.directions() > 0) hold_similarity(component, freedom);
    }
    // A vertex of which one dimension holds directions may be held completely because of the other one.
    const auto is_held = [&](const TangentDirection& direction) {
      return std::any_of(gauge_.held.begin() + static_cast<std::ptrdiff_t>(held), gauge_.held.end(),
                         [&](const detail::GaugeVertex& v) { return v.vertex == direction.vertex; });
    };
    std::erase_if(gauge_.held_directions, is_held);
    if (!component.anchored && component.free.empty())
      gauge_.loose.push_back(reference(first_choice(component)));
  }

  /// The freedom of the selected component. If a sample of the edges leaves directions free, and only these
  /// are held, every step checks whether they are still free. Otherwise, all edges have to leave them free.
  SimilarityFreedom freedom_of(const Component& component, int dimension) {
    SimilarityFreedom freedom = test_->find(dimension, SimilarityTest::Extent::kSample);
    if (freedom.directions() == 0) return freedom;
    if (holds(component) && !holds_whole(component, gauge_vertex(component, freedom), freedom))
      return freedom;
    return test_->find(dimension, SimilarityTest::Extent::kAllEdges);
  }

  /// Leaves out the motions that change what is held since there were `held` vertices and `held_directions`,
  /// because of the other dimension of the world.
  void leave_out_held(SimilarityFreedom& freedom, std::size_t held, std::size_t held_directions) const {
    const auto changes_of = [&](const VertexRef& v) { return freedom.of_vertex(graph_, {v.pool, v.slot}); };
    for (std::size_t k = held; k < gauge_.held.size() && freedom.directions() > 0; ++k)
      freedom.keep(kernel_of(changes_of(gauge_.held[k].vertex), kNoticeable * freedom.unit()));
    for (std::size_t k = held_directions; k < gauge_.held_directions.size() && freedom.directions() > 0;
         ++k) {
      const auto& [vertex, row] = gauge_.held_directions[k];
      freedom.keep(kernel_of(changes_of(vertex).row(row), kNoticeable * freedom.unit()));
    }
  }

  bool holds_whole(const Component& component, VertexSlot first, const SimilarityFreedom& freedom) const {
    return component.left_out.empty() && !component.anchored && is_all_gauge(first, freedom);
  }

  /// Handles a component that has only relative poses. All directions of its first pose are gauge freedom.
  void hold_rigid(Component& component, VertexSlot first, int dimension) {
    const detail::VertexPool& pool = pool_of(first);
    component.free = {all_rigid_motions(dimension)};
    component.moved = component.vertices;
    if (holds(component)) {
      gauge_.held.push_back({reference(first), pool.id(first.slot)});
    } else {
      gauge_.freedoms.push_back(
          {reference(first), pool.id(first.slot), pool.tangent_dim(first.slot), true, true, false});
    }
  }

  void hold_similarity(Component& component, const SimilarityFreedom& freedom) {
    std::copy_if(component.vertices.begin(), component.vertices.end(), std::back_inserter(component.moved),
                 [&](VertexSlot v) { return freedom.role(v) != WorldRole::kNone; });
    component.free.push_back(free_motions_of(freedom));
    const VertexSlot first = gauge_vertex(component, freedom);
    const Id id = pool_of(first).id(first.slot);
    SimilarityFreedom left = freedom;  // the freedom that remains
    if (holds(component)) {
      if (holds_whole(component, first, freedom)) {
        gauge_.held.push_back({reference(first), id});
        left.keep(kernel_of(freedom.of_vertex(graph_, first), kNoticeable * freedom.unit()));
      }
      hold_directions(component, first, left);
    }
    if (left.directions() == 0) return;
    const FreeMotions motions = free_motions_of(left);
    gauge_.freedoms.push_back(
        {reference(first), id, motions.count, !motions.along.empty(), !motions.about.empty(), motions.scale});
  }

  int taken_by(VertexSlot v, const SimilarityFreedom& freedom) const {
    const MatrixXd own = freedom.of_vertex(graph_, v);
    return freedom.directions() - static_cast<int>(kernel_of(own, kNoticeable * freedom.unit()).cols());
  }
  bool is_all_gauge(VertexSlot v, const SimilarityFreedom& freedom) const {
    return taken_by(v, freedom) == pool_of(v).tangent_dim(v.slot);
  }

  /// The vertex that removes most of the gauge freedom if it is held. Among several such vertices, prefers a
  /// vertex whose directions are all gauge freedom.
  VertexSlot gauge_vertex(const Component& component, const SimilarityFreedom& freedom) const {
    std::vector<VertexSlot> firsts;  // the vertex with the lowest rank of each vertex pool and role
    for (const VertexSlot v : component.vertices) {
      const auto same = std::find_if(firsts.begin(), firsts.end(), [&](VertexSlot f) {
        return f.pool == v.pool && freedom.role(f) == freedom.role(v);
      });
      if (same == firsts.end()) {
        firsts.push_back(v);
      } else if (rank(v) < rank(*same)) {
        *same = v;
      }
    }
    return first_by(firsts, [&](VertexSlot v) {
      return std::tuple(-taken_by(v, freedom), !is_all_gauge(v, freedom), rank(v));
    });
  }

  /// Holds as many tangent directions as there are free motions, preferably directions of `first`. Every free
  /// motion changes at least one held direction. So there is an exact Gauss-Newton step that is zero in all
  /// held directions.
  void hold_directions(const Component& component, VertexSlot first, SimilarityFreedom left) {
    std::vector<bool> is_determined;
    while (left.directions() > 0) {
      const auto row_norms = [&](VertexSlot v) -> Eigen::VectorXd {
        return left.of_vertex(graph_, v).rowwise().norm();
      };
      VertexSlot best = first;
      const double least = kNoticeable * left.unit();
      if (pool_of(first).eliminated(first.slot) || row_norms(first).maxCoeff() <= least) {
        if (is_determined.empty()) is_determined = components_.find_determined(component);
        std::tuple most(false, least);
        for (std::size_t k = 0; k < component.vertices.size(); ++k) {
          const VertexSlot v = component.vertices[k];
          if (pool_of(v).eliminated(v.slot)) continue;
          const std::tuple size(bool{is_determined[k]}, row_norms(v).maxCoeff());
          if (std::get<1>(size) > least && size > most) std::tie(most, best) = std::tuple(size, v);
        }
        if (std::get<1>(most) <= least) return;
      }
      Eigen::Index row = 0;
      row_norms(best).maxCoeff(&row);
      gauge_.held_directions.push_back({reference(best), static_cast<int>(row)});
      left.keep(kernel_of(left.of_vertex(graph_, best).row(row), kNoticeable * left.unit()));
    }
  }

  const Graph& graph_;
  const std::vector<std::vector<std::uint8_t>>& movable_;
  std::vector<std::uint8_t> is_shared_;  // by GraphView::number()
  EdgeEnds ends_;
  GaugePolicy policy_;
  GaugeBounds bounds_;
  const StopToken& stop_;
  ComponentFinder components_;
  std::unique_ptr<SimilarityTest> test_;
  bool is_selected_ = false;  // whether the component to decide on is that of `test_`
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
                 const StopToken& stop, GaugeBounds bounds) {
  return GaugeFinder(graph, movable, policy, bounds, stop).find(active_edges);
}

}  // namespace boxplus
