// SPDX-License-Identifier: BSD-3-Clause
// Propagates initial estimates from vertex to vertex along the cheapest edges.
#pragma once
#ifndef G2O_ESTIMATE_PROPAGATOR_H
#define G2O_ESTIMATE_PROPAGATOR_H

#include <functional>
#include <limits>
#include <set>
#include <unordered_map>

#include "g2o/core/sparse_optimizer.h"

namespace g2o {

/// Computes the cost of initializing the estimate of a vertex from other vertices of the same edge. The cost
/// is std::numeric_limits<double>::max() if this is impossible. By default, the cost of an active edge is
/// Edge::initialEstimatePossible(), and the use of other edges is impossible.
class G2O_CORE_API EstimatePropagatorCost {
 public:
  explicit EstimatePropagatorCost(SparseOptimizer* graph);
  virtual ~EstimatePropagatorCost();
  virtual double operator()(OptimizableGraph::Edge* edge, const OptimizableGraph::VertexSet& from,
                            OptimizableGraph::Vertex* to_) const;
  virtual const char* name() const { return "spanning tree"; }

 protected:
  SparseOptimizer* _graph;
};

/// Uses only edges between vertices with consecutive ids.
class G2O_CORE_API EstimatePropagatorCostOdometry : public EstimatePropagatorCost {
 public:
  explicit EstimatePropagatorCostOdometry(SparseOptimizer* graph);
  double operator()(OptimizableGraph::Edge* edge, const OptimizableGraph::VertexSet& from_,
                    OptimizableGraph::Vertex* to_) const override;
  const char* name() const override { return "odometry"; }
};

/// Propagates estimates along the cheapest paths, which Dijkstra's algorithm computes. Edges may have more
/// than two vertices.
class G2O_CORE_API EstimatePropagator {
 public:
  /// The action of propagate(), which is called for each vertex on a path. By default, it calls
  /// Edge::initialEstimate() unless the vertex is fixed.
  struct G2O_CORE_API PropagateAction {
    virtual ~PropagateAction();
    virtual void operator()(OptimizableGraph::Edge* e, const OptimizableGraph::VertexSet& from,
                            OptimizableGraph::Vertex* to) const {
      if (!to->fixed()) e->initialEstimate(from, to);
    }
  };
  using PropagateCost = EstimatePropagatorCost;

  /// The last step of the cheapest path to a vertex.
  class G2O_CORE_API AdjacencyMapEntry {
   public:
    friend class EstimatePropagator;
    OptimizableGraph::Vertex* child() const { return _child; }
    const OptimizableGraph::VertexSet& parent() const { return _parent; }
    OptimizableGraph::Edge* edge() const { return _edge; }
    double distance() const { return _distance; }
    int frontierLevel() const { return _frontierLevel; }

   protected:
    OptimizableGraph::Vertex* _child = nullptr;
    OptimizableGraph::VertexSet _parent;
    OptimizableGraph::Edge* _edge = nullptr;
    double _distance = std::numeric_limits<double>::max();
    int _frontierLevel = -1;
  };
  using AdjacencyMap = std::unordered_map<OptimizableGraph::Vertex*, AdjacencyMapEntry>;

  explicit EstimatePropagator(OptimizableGraph* g);

  OptimizableGraph::VertexSet& visited() { return _visited; }
  AdjacencyMap& adjacencyMap() { return _adjacencyMap; }
  OptimizableGraph* graph() { return _graph; }

  void propagate(OptimizableGraph::Vertex* v, const PropagateCost& cost,
                 const PropagateAction& action = PropagateAction(),
                 double maxDistance = std::numeric_limits<double>::max(),
                 double maxEdgeCost = std::numeric_limits<double>::max());
  void propagate(OptimizableGraph::VertexSet& vset, const PropagateCost& cost,
                 const PropagateAction& action = PropagateAction(),
                 double maxDistance = std::numeric_limits<double>::max(),
                 double maxEdgeCost = std::numeric_limits<double>::max());

 protected:
  AdjacencyMap _adjacencyMap;
  OptimizableGraph::VertexSet _visited;
  OptimizableGraph* _graph;
};

}  // namespace g2o

#endif  // G2O_ESTIMATE_PROPAGATOR_H
