// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/false_closures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "graph/graph_view.h"
#include "testing/random_numbers.h"

namespace boxplus {
namespace {

template <class Pose>
class FalseClosures {
 public:
  FalseClosures(Graph& graph, const FalseClosureOptions& options)
      : graph_(graph), options_(options), random_(options.seed) {
    const EdgeRoles role(graph);
    for (const VertexRef& vertex : role.trajectory()) {
      if (dynamic_cast<const detail::TypedVertexPool<Pose>*>(graph.vertex_pools()[vertex.pool].get()))
        poses_.push_back(graph.typed<Pose>(vertex));
    }
    for (const EdgeRef& edge : graph.all_edges()) {
      const detail::EdgePool* pool = graph.edge_pools()[edge.pool].get();
      if (dynamic_cast<const detail::TypedEdgePool<Edge, Pose, Pose>*>(pool) != nullptr &&
          role(edge) == EdgeRole::kLoopClosure)
        closures_.push_back({edge});
    }
  }

  bool finds_closures() const { return !closures_.empty(); }

  std::vector<EdgeRef> add() {
    const double share = options_.fraction / (1 - options_.fraction);
    const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(closures_.size())));
    const std::size_t most_tries = 100 * wanted;
    std::vector<EdgeRef> added;
    for (std::size_t tries = 0; added.size() < wanted && tries < most_tries; ++tries) {
      add_group(std::min(wanted - added.size(), static_cast<std::size_t>(1 + random_.below(options_.group))),
                added);
    }
    return added;
  }

 private:
  using Edge = Between<Pose>;

  void add_group(std::size_t size, std::vector<EdgeRef>& added) {
    const EdgeHandle<Edge> model = closures_[below(closures_.size())];
    const std::size_t a = below(poses_.size()), b = below(poses_.size());
    const Pose motion = graph_.measurement(model).measurement;
    if (!is_false(model, motion, a, b)) return;
    for (std::size_t k = 0; k < size && std::max(a, b) + k < poses_.size(); ++k) {
      const Pose to_a = pose(a).inverse_times(pose(a + k)), to_b = pose(b).inverse_times(pose(b + k));
      const Information information(graph_.information(model).matrix());
      added.push_back(
          graph_.add_edge(Edge(to_a.inverse() * motion * to_b), information, poses_[a + k], poses_[b + k]));
    }
  }

  bool is_false(EdgeHandle<Edge> model, const Pose& motion, std::size_t a, std::size_t b) const {
    if (std::max(a, b) - std::min(a, b) < 2) return false;
    constexpr double kFarOff = 100;
    const detail::InformationView information = graph_.information(model);
    const auto error = Edge(motion).error(pose(a), pose(b));
    return information.squared_norm(error.data()) > kFarOff * information.rows;
  }

  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.below(static_cast<int>(count)));
  }
  const Pose& pose(std::size_t rank) const { return graph_.estimate(poses_[rank]); }

  Graph& graph_;
  const FalseClosureOptions& options_;
  RandomNumbers random_;
  std::vector<VertexHandle<Pose>> poses_;  // by id
  std::vector<EdgeHandle<Edge>> closures_;
};

void check(const FalseClosureOptions& options) {
  if (!(options.fraction >= 0 && options.fraction < 1))
    throw InvalidArgument("add_false_closures: expected a fraction in [0, 1), got " +
                          std::to_string(options.fraction));
  if (options.group < 1)
    throw InvalidArgument("add_false_closures: expected groups of at least 1, got " +
                          std::to_string(options.group));
}

}  // namespace

std::vector<EdgeRef> add_false_closures(Graph& graph, const FalseClosureOptions& options) {
  check(options);
  FalseClosures<SE2> plane(graph, options);
  if (plane.finds_closures()) return plane.add();
  FalseClosures<SE3> space(graph, options);
  if (space.finds_closures()) return space.add();
  throw InvalidArgument("add_false_closures: expected a loop closure between poses SE2 or SE3, got none");
}

}  // namespace boxplus
