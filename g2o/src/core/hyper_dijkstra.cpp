// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/hyper_dijkstra.h"

#include <deque>
#include <queue>
#include <tuple>
#include <vector>

namespace g2o {

HyperDijkstra::CostFunction::~CostFunction() = default;
HyperDijkstra::TreeAction::~TreeAction() = default;

double HyperDijkstra::TreeAction::perform(HyperGraph::Vertex*, HyperGraph::Vertex*, HyperGraph::Edge*) {
  return -1;
}

double HyperDijkstra::TreeAction::perform(HyperGraph::Vertex* v, HyperGraph::Vertex* vParent,
                                          HyperGraph::Edge* e, double distance) {
  return distance == -1 ? perform(v, vParent, e) : 1;
}

HyperDijkstra::AdjacencyMapEntry::AdjacencyMapEntry(HyperGraph::Vertex* child, HyperGraph::Vertex* parent,
                                                    HyperGraph::Edge* edge, double distance)
    : _child(child), _parent(parent), _edge(edge), _distance(distance) {}

HyperDijkstra::HyperDijkstra(HyperGraph* g) : _graph(g) {
  for (const auto& [id, v] : g->vertices()) _adjacencyMap.emplace(v, AdjacencyMapEntry(v));
}

void HyperDijkstra::reset() {
  for (HyperGraph::Vertex* v : _visited) _adjacencyMap[v] = AdjacencyMapEntry(v);
  _visited.clear();
}

void HyperDijkstra::shortestPaths(HyperGraph::Vertex* v, HyperDijkstra::CostFunction* cost,
                                  double maxDistance, double comparisonConditioner, bool directed,
                                  double maxEdgeCost) {
  HyperGraph::VertexSet vset{v};
  shortestPaths(vset, cost, maxDistance, comparisonConditioner, directed, maxEdgeCost);
}

void HyperDijkstra::shortestPaths(HyperGraph::VertexSet& vset, HyperDijkstra::CostFunction* cost,
                                  double maxDistance, double comparisonConditioner, bool directed,
                                  double maxEdgeCost) {
  using Entry = std::tuple<double, int, HyperGraph::Vertex*>;  // ordered by distance; the id breaks ties
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> frontier;
  reset();
  HyperGraph::VertexSet done;
  for (HyperGraph::Vertex* v : vset) {
    _adjacencyMap[v] = AdjacencyMapEntry(v, nullptr, nullptr, 0);
    _visited.insert(v);
    frontier.emplace(0., v->id(), v);
  }
  while (!frontier.empty()) {
    HyperGraph::Vertex* u = std::get<2>(frontier.top());
    frontier.pop();
    if (!done.insert(u).second) continue;
    const double reached = _adjacencyMap[u].distance();
    for (HyperGraph::Edge* e : u->edges()) {
      if (directed && e->vertex(0) != u) continue;
      for (HyperGraph::Vertex* z : e->vertices()) {
        if (z == nullptr || z == u) continue;
        const double edge_cost = (*cost)(e, u, z);
        if (edge_cost == std::numeric_limits<double>::max() || edge_cost > maxEdgeCost) continue;
        const double distance = reached + edge_cost;
        AdjacencyMapEntry& entry = _adjacencyMap[z];
        if (distance >= maxDistance || !(distance + comparisonConditioner < entry.distance())) continue;
        entry = AdjacencyMapEntry(z, u, e, distance);
        _visited.insert(z);
        frontier.emplace(distance, z->id(), z);
      }
    }
  }
}

void HyperDijkstra::computeTree(AdjacencyMap& amap) {
  for (auto& [v, entry] : amap) entry._children.clear();
  for (auto& [v, entry] : amap) {
    if (entry._parent != nullptr) amap[entry._parent]._children.insert(v);
  }
}

void HyperDijkstra::visitAdjacencyMap(AdjacencyMap& amap, TreeAction* action, bool useDistance) {
  std::deque<HyperGraph::Vertex*> queue;
  for (auto& [v, entry] : amap) {
    if (entry._parent == nullptr && !entry._children.empty()) {
      action->perform(v, nullptr, nullptr);
      queue.push_back(v);
    }
  }
  while (!queue.empty()) {
    HyperGraph::Vertex* parent = queue.front();
    queue.pop_front();
    for (HyperGraph::Vertex* v : amap[parent]._children) {
      const AdjacencyMapEntry& entry = amap[v];
      if (useDistance) {
        action->perform(v, parent, entry._edge, entry._distance);
      } else {
        action->perform(v, parent, entry._edge);
      }
      queue.push_back(v);
    }
  }
}

void HyperDijkstra::connectedSubset(HyperGraph::VertexSet& connected, HyperGraph::VertexSet& visited,
                                    HyperGraph::VertexSet& startingSet, HyperGraph* g, HyperGraph::Vertex* v,
                                    HyperDijkstra::CostFunction* cost, double distance,
                                    double comparisonConditioner, double maxEdgeCost) {
  HyperDijkstra paths(g);
  paths.shortestPaths(v, cost, distance, comparisonConditioner, false, maxEdgeCost);
  for (HyperGraph::Vertex* u : paths.visited()) {
    visited.insert(u);
    if (startingSet.count(u) > 0) connected.insert(u);
  }
}

double UniformCostFunction::operator()(HyperGraph::Edge*, HyperGraph::Vertex*, HyperGraph::Vertex*) {
  return 1;
}

}  // namespace g2o
