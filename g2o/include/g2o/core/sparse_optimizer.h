// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_GRAPH_OPTIMIZER_CHOL_H_
#define G2O_GRAPH_OPTIMIZER_CHOL_H_

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "g2o/core/batch_stats.h"
#include "g2o/core/optimizable_graph.h"
#include "g2o/core/sparse_block_matrix.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {

class EstimatePropagatorCost;
class OptimizationAlgorithm;
class Solver;
namespace internal {
class BlockSolverEngine;
class EdgeParts;
}  // namespace internal

/// A graph that can be optimized. Set an algorithm, call initializeOptimization(), then call optimize().
class G2O_CORE_API SparseOptimizer : public OptimizableGraph {
 public:
  enum { AT_COMPUTEACTIVERROR = OptimizableGraph::AT_NUM_ELEMENTS, AT_NUM_ELEMENTS };

  SparseOptimizer();
  ~SparseOptimizer() override;

  /// Selects the active edges and vertices. The first overload selects the given edges and their vertices.
  /// The second overload selects the edges of a level between the given vertices. The third overload selects
  /// all edges of a level. A negative level selects the edges of all levels. Returns false if there is
  /// nothing to optimize.
  virtual bool initializeOptimization(HyperGraph::EdgeSet& eset);
  virtual bool initializeOptimization(HyperGraph::VertexSet& vset, int level = 0);
  virtual bool initializeOptimization(int level = 0);
  /// Makes more vertices and edges active. Returns false if a new vertex is marginalized.
  virtual bool updateInitialization(HyperGraph::VertexSet& vset, HyperGraph::EdgeSet& eset);

  /// Computes initial estimates. Starts at fixed vertices and priors, and follows edges that support
  /// initialEstimate().
  virtual void computeInitialGuess();
  virtual void computeInitialGuess(EstimatePropagatorCost& propagator);
  virtual void setToOrigin();

  /// Runs at most `iterations` iterations. Returns the number of iterations. Returns 0 if the last iteration
  /// failed, or −1 if the optimization could not start.
  int optimize(int iterations, bool online = false) override;

  /// Computes blocks of H⁻¹, selected by pairs of Hessian indices, or the diagonal blocks of the given
  /// vertices. H is the Hessian of the last linearization, without damping.
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                        const std::vector<std::pair<int, int>>& blockIndices);
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const Vertex* vertex);
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const VertexContainer& vertices);

  /// Returns the vertex with the lowest id among the vertices of the largest dimension. Clients can call
  /// setFixed(true) of this vertex to fix the gauge. Returns nullptr if the graph has no vertices.
  virtual Vertex* findGauge();
  /// Returns true if neither a fixed vertex nor a prior of full dimension fixes the gauge.
  bool gaugeFreedom();

  /// Return the sum of eᵀΩe, or of ρ(eᵀΩe), over the active edges. These functions use the errors that were
  /// computed last.
  double activeChi2() const;
  double activeRobustChi2() const;

  /// If true, optimize() writes one line per iteration to std::cerr.
  bool verbose() const { return _verbose; }
  void setVerbose(bool verbose);

  /// optimize() stops when *flag is true. The caller owns the flag. Pass nullptr to remove the flag.
  void setForceStopFlag(bool* flag);
  bool* forceStopFlag() const { return _forceStopFlag; }
  bool terminate() { return _forceStopFlag != nullptr && *_forceStopFlag; }

  /// The active vertices that are not fixed, in the order of Hessian indices.
  const VertexContainer& indexMapping() const { return _ivMap; }
  const VertexContainer& activeVertices() const { return _activeVertices; }
  const EdgeContainer& activeEdges() const { return _activeEdges; }

  bool removeVertex(HyperGraph::Vertex* v, bool detach = false) override;
  bool removeEdge(HyperGraph::Edge* e) override;
  bool changeId(HyperGraph::Vertex* v, int newId) override;
  bool setEdgeVertex(HyperGraph::Edge* e, int pos, HyperGraph::Vertex* v) override;
  VertexContainer::const_iterator findActiveVertex(const OptimizableGraph::Vertex* v) const;
  EdgeContainer::const_iterator findActiveEdge(const OptimizableGraph::Edge* e) const;

  const OptimizationAlgorithm* algorithm() const { return _algorithm; }
  OptimizationAlgorithm* solver() { return _algorithm; }
  /// Takes ownership of the algorithm and deletes the previous algorithm. If an action calls this function
  /// during optimize(), the previous algorithm is deleted when optimize() ends. The next iteration uses the
  /// new algorithm. If the new algorithm is nullptr, optimize() stops instead.
  void setAlgorithm(OptimizationAlgorithm* algorithm);
  void setAlgorithm(std::unique_ptr<OptimizationAlgorithm> algorithm);

  using OptimizableGraph::discardTop;
  using OptimizableGraph::pop;
  using OptimizableGraph::push;
  void push(VertexContainer& vlist);
  void push(HyperGraph::VertexSet& vlist) override;
  /// Saves the estimates of all active vertices.
  void push() override;
  void pop(VertexContainer& vlist);
  void pop(HyperGraph::VertexSet& vlist) override;
  void pop() override;
  void discardTop(VertexContainer& vlist);
  void discardTop() override;

  /// Removes all vertices and edges. Keeps the parameters and the algorithm.
  void clear() override;

  /// Calls computeError() of every active edge.
  void computeActiveErrors();
  G2O_ATTRIBUTE_DEPRECATED(void linearizeSystem()) {}

  /// Moves the vertices of indexMapping() by the increments in `update`. The algorithms call this function
  /// for each step that they try.
  virtual void update(const double* update);

  const BatchStatisticsContainer& batchStatistics() const { return _batchStatistics; }
  BatchStatisticsContainer& batchStatistics() { return _batchStatistics; }
  void setComputeBatchStatistics(bool computeBatchStatistics);
  bool computeBatchStatistics() const { return _computeBatchStatistics; }

  bool addComputeErrorAction(HyperGraphAction* action);
  bool removeComputeErrorAction(HyperGraphAction* action);

 protected:
  bool* _forceStopFlag = nullptr;
  bool _verbose = false;

  VertexContainer _ivMap;
  VertexContainer _activeVertices;
  EdgeContainer _activeEdges;

  OptimizationAlgorithm* _algorithm = nullptr;  ///< owned by the optimizer
  BatchStatisticsContainer _batchStatistics;
  bool _computeBatchStatistics = false;

  void sortVectorContainers();
  /// Assigns Hessian indices to the vertices that are not fixed, in the order of `vlist`: first to the
  /// vertices that are not marginalized, then to the marginalized vertices.
  bool buildIndexMapping(SparseOptimizer::VertexContainer& vlist);
  void clearIndexMapping();

 private:
  friend class SparseOptimizerTerminateAction;
  friend class OptimizationAlgorithmWithHessian;
  friend class internal::BlockSolverEngine;
  /// The stop flag that actions set if the client has not set a flag. The optimizer owns this flag, because
  /// an action may be destroyed before the optimizer.
  bool own_stop_flag_ = false;
  /// Increases whenever the active vertices, the active edges or the Hessian indices change.
  std::uint64_t structure_revision_ = 0;
  /// The memory of the Hessian blocks of the active vertices. The optimizer keeps it, so that hessian() of a
  /// vertex also works after the solver is destroyed.
  std::shared_ptr<const void> hessian_memory_;
  /// The edges that several threads may evaluate. The list is outdated if parts_revision_ differs from
  /// structure_revision_.
  std::unique_ptr<internal::EdgeParts> edge_parts_;
  std::uint64_t parts_revision_ = 0;

  /// The number of nested optimize() calls (an action may call optimize() again). Replaced algorithms are
  /// kept until the outermost call ends.
  int optimize_depth_ = 0;
  std::vector<std::unique_ptr<OptimizationAlgorithm>> replaced_algorithms_;
  class OptimizeScope;

  /// If true, buildSystem() computes the errors of the edges that the library evaluates in batches.
  bool errors_postponed_ = false;
  /// Whether the last pass over the edges found an edge that has lost a vertex.
  bool lost_vertices_ = false;

  internal::EdgeParts& edgeParts();
  /// Does the same as computeActiveErrors(), but leaves the errors of edges that the library evaluates in
  /// batches to the next Solver::buildSystem().
  void postponeActiveErrors();
  /// Returns the same as activeRobustChi2() directly after computeActiveErrors() or buildSystem(), which have
  /// already added up chi2 of most edges.
  double robustChi2OfPass() const;
  void dropIncompleteEdges();
  bool startOptimization();
  void sizeWorkspace();
  void forgetInitialization();
  void writeVerboseLine(const OptimizationAlgorithm& algorithm, int iteration, double seconds,
                        double total) const;
};

}  // namespace g2o

#endif  // G2O_GRAPH_OPTIMIZER_CHOL_H_
