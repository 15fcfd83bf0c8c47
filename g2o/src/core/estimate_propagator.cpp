// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/estimate_propagator.h"

#include <cstdlib>
#include <queue>
#include <tuple>
#include <vector>

namespace g2o {

EstimatePropagatorCost::EstimatePropagatorCost(SparseOptimizer* graph) : _graph(graph) {}
EstimatePropagatorCost::~EstimatePropagatorCost() = default;

double EstimatePropagatorCost::operator()(OptimizableGraph::Edge* edge,
                                          const OptimizableGraph::VertexSet& from,
                                          OptimizableGraph::Vertex* to_) const {
  constexpr double kImpossible = std::numeric_limits<double>::max();
  if (_graph->findActiveEdge(edge) == _graph->activeEdges().end()) return kImpossible;
  const double cost = edge->initialEstimatePossible(from, to_);
  return cost > 0 ? cost : kImpossible;
}

EstimatePropagatorCostOdometry::EstimatePropagatorCostOdometry(SparseOptimizer* graph)
    : EstimatePropagatorCost(graph) {}

double EstimatePropagatorCostOdometry::operator()(OptimizableGraph::Edge* edge,
                                                  const OptimizableGraph::VertexSet& from_,
                                                  OptimizableGraph::Vertex* to_) const {
  constexpr double kImpossible = std::numeric_limits<double>::max();
  if (from_.size() != 1 || std::abs((*from_.begin())->id() - to_->id()) != 1) return kImpossible;
  return EstimatePropagatorCost::operator()(edge, from_, to_);
}

EstimatePropagator::PropagateAction::~PropagateAction() = default;

EstimatePropagator::EstimatePropagator(OptimizableGraph* g) : _graph(g) {}

void EstimatePropagator::propagate(OptimizableGraph::Vertex* v, const PropagateCost& cost,
                                   const PropagateAction& action, double maxDistance, double maxEdgeCost) {
  OptimizableGraph::VertexSet vset{v};
  propagate(vset, cost, action, maxDistance, maxEdgeCost);
}

void EstimatePropagator::propagate(OptimizableGraph::VertexSet& vset, const PropagateCost& cost,
                                   const PropagateAction& action, double maxDistance, double maxEdgeCost) {
  using Entry =
      std::tuple<double, int, OptimizableGraph::Vertex*>;  // ordered by distance; the id breaks ties
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> frontier;
  _adjacencyMap.clear();
  _visited.clear();
  for (HyperGraph::Vertex* u : vset) {
    auto* v = static_cast<OptimizableGraph::Vertex*>(u);
    AdjacencyMapEntry& entry = _adjacencyMap[v];
    entry._child = v;
    entry._distance = 0;
    entry._frontierLevel = 0;
    frontier.emplace(0., v->id(), v);
  }
  while (!frontier.empty()) {
    auto* u = std::get<2>(frontier.top());
    frontier.pop();
    if (!_visited.insert(u).second) continue;
    const AdjacencyMapEntry reached = _adjacencyMap[u];
    if (reached._edge != nullptr) action(reached._edge, reached._parent, u);
    for (HyperGraph::Edge* e : u->edges()) {
      auto* edge = static_cast<OptimizableGraph::Edge*>(e);
      OptimizableGraph::VertexSet known;
      for (HyperGraph::Vertex* v : edge->vertices())
        if (_visited.count(v) > 0) known.insert(v);
      for (HyperGraph::Vertex* w : edge->vertices()) {
        if (w == nullptr || known.count(w) > 0) continue;
        auto* to = static_cast<OptimizableGraph::Vertex*>(w);
        const double edge_cost = cost(edge, known, to);
        const bool possible = edge_cost > 0 && edge_cost < std::numeric_limits<double>::max();
        if (!possible || edge_cost > maxEdgeCost) continue;
        const double distance = reached._distance + edge_cost;
        AdjacencyMapEntry& entry = _adjacencyMap[to];
        if (distance > maxDistance || distance >= entry._distance) continue;
        entry._child = to;
        entry._parent = known;
        entry._edge = edge;
        entry._distance = distance;
        entry._frontierLevel = reached._frontierLevel + 1;
        frontier.emplace(distance, to->id(), to);
      }
    }
  }
}

}  // namespace g2o
