// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths in a hyper-graph.
#pragma once
#ifndef G2O_AIS_GENERAL_DIJKSTRA_HH
#define G2O_AIS_GENERAL_DIJKSTRA_HH

#include <functional>
#include <limits>
#include <map>
#include <set>

#include "g2o/core/hyper_graph.h"

namespace g2o {

struct G2O_CORE_API HyperDijkstra {
  /// The cost of going from one vertex of an edge to another vertex of the same edge. Returns
  /// std::numeric_limits<double>::max() if this is impossible.
  struct G2O_CORE_API CostFunction {
    virtual double operator()(HyperGraph::Edge* e, HyperGraph::Vertex* from, HyperGraph::Vertex* to) = 0;
    virtual ~CostFunction();
  };

  /// The action of visitAdjacencyMap(), which is called for each vertex of a tree of shortest paths.
  struct G2O_CORE_API TreeAction {
    virtual ~TreeAction();
    virtual double perform(HyperGraph::Vertex* v, HyperGraph::Vertex* vParent, HyperGraph::Edge* e);
    virtual double perform(HyperGraph::Vertex* v, HyperGraph::Vertex* vParent, HyperGraph::Edge* e,
                           double distance);
  };

  /// The last step of the shortest path to a vertex.
  class G2O_CORE_API AdjacencyMapEntry {
   public:
    friend struct HyperDijkstra;
    AdjacencyMapEntry(HyperGraph::Vertex* child = nullptr, HyperGraph::Vertex* parent = nullptr,
                      HyperGraph::Edge* edge = nullptr, double distance = std::numeric_limits<double>::max());
    HyperGraph::Vertex* child() const { return _child; }
    HyperGraph::Vertex* parent() const { return _parent; }
    HyperGraph::Edge* edge() const { return _edge; }
    double distance() const { return _distance; }
    HyperGraph::VertexSet& children() { return _children; }
    const HyperGraph::VertexSet& children() const { return _children; }

   protected:
    HyperGraph::Vertex* _child;
    HyperGraph::Vertex* _parent;
    HyperGraph::Edge* _edge;
    double _distance;
    HyperGraph::VertexSet _children;
  };
  using AdjacencyMap = std::map<HyperGraph::Vertex*, AdjacencyMapEntry>;

  explicit HyperDijkstra(HyperGraph* g);

  HyperGraph::VertexSet& visited() { return _visited; }
  AdjacencyMap& adjacencyMap() { return _adjacencyMap; }
  HyperGraph* graph() { return _graph; }

  /// Computes the shortest paths from one vertex, or from the nearest of several vertices, to all vertices at
  /// a distance below maxDistance. A new path replaces a known path if it is shorter by more than
  /// comparisonConditioner. If `directed` is true, paths use an edge only from its first vertex to its other
  /// vertices.
  void shortestPaths(HyperGraph::Vertex* v, HyperDijkstra::CostFunction* cost,
                     double maxDistance = std::numeric_limits<double>::max(),
                     double comparisonConditioner = 1e-3, bool directed = false,
                     double maxEdgeCost = std::numeric_limits<double>::max());
  void shortestPaths(HyperGraph::VertexSet& vset, HyperDijkstra::CostFunction* cost,
                     double maxDistance = std::numeric_limits<double>::max(),
                     double comparisonConditioner = 1e-3, bool directed = false,
                     double maxEdgeCost = std::numeric_limits<double>::max());

  /// Computes children() of all entries from parent() of all entries.
  static void computeTree(AdjacencyMap& amap);
  /// Calls the action from the roots to the leaves. Passes the distance if useDistance is true.
  static void visitAdjacencyMap(AdjacencyMap& amap, TreeAction* action, bool useDistance = false);
  /// Adds to `connected` all vertices of startingSet that can be reached from v.
  static void connectedSubset(HyperGraph::VertexSet& connected, HyperGraph::VertexSet& visited,
                              HyperGraph::VertexSet& startingSet, HyperGraph* g, HyperGraph::Vertex* v,
                              HyperDijkstra::CostFunction* cost, double distance,
                              double comparisonConditioner,
                              double maxEdgeCost = std::numeric_limits<double>::max());

 protected:
  void reset();

  AdjacencyMap _adjacencyMap;
  HyperGraph::VertexSet _visited;
  HyperGraph* _graph;
};

/// A cost function that returns 1 for every edge.
struct G2O_CORE_API UniformCostFunction : public HyperDijkstra::CostFunction {
  double operator()(HyperGraph::Edge* edge, HyperGraph::Vertex* from, HyperGraph::Vertex* to) override;
};

}  // namespace g2o

#endif  // G2O_AIS_GENERAL_DIJKSTRA_HH
