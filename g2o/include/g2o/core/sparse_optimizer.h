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

/// A graph that can be optimised. Choose an algorithm, initialise what takes part, optimise.
class G2O_CORE_API SparseOptimizer : public OptimizableGraph {
 public:
  enum { AT_COMPUTEACTIVERROR = OptimizableGraph::AT_NUM_ELEMENTS, AT_NUM_ELEMENTS };

  SparseOptimizer();
  ~SparseOptimizer() override;

  /// What takes part: the given edges and their vertices; the given vertices and the edges of a level between
  /// them; or all edges of a level (negative: of all levels). False where nothing is left to optimise.
  virtual bool initializeOptimization(HyperGraph::EdgeSet& eset);
  virtual bool initializeOptimization(HyperGraph::VertexSet& vset, int level = 0);
  virtual bool initializeOptimization(int level = 0);
  /// Lets vertices and edges that were added take part, too. False where a new vertex is marginalised.
  virtual bool updateInitialization(HyperGraph::VertexSet& vset, HyperGraph::EdgeSet& eset);

  /// Propagates the estimates of fixed vertices along edges that offer initialEstimate().
  virtual void computeInitialGuess();
  virtual void computeInitialGuess(EstimatePropagatorCost& propagator);
  virtual void setToOrigin();

  /// Runs at most `iterations` iterations. Returns how many there were; 0 where the last one failed; −1 where
  /// nothing was initialised.
  int optimize(int iterations, bool online = false) override;

  /// Blocks of the inverse of H, by Hessian index; the diagonal blocks of vertices. H is undamped, and of the
  /// last linearisation.
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                        const std::vector<std::pair<int, int>>& blockIndices);
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const Vertex* vertex);
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const VertexContainer& vertices);

  /// The vertex of largest dimension with the lowest id; nullptr in an empty graph.
  virtual Vertex* findGauge();
  /// Whether neither a fixed vertex nor a prior of full dimension holds the graph in place.
  bool gaugeFreedom();

  /// Σ eᵀΩe (Σ ρ(eᵀΩe)) over the active edges, of the errors as last computed.
  double activeChi2() const;
  double activeRobustChi2() const;

  /// Whether optimize() writes a line per iteration to std::cerr.
  bool verbose() const { return _verbose; }
  void setVerbose(bool verbose);

  /// optimize() ends once *flag is true. The flag stays the caller's; nullptr: none.
  void setForceStopFlag(bool* flag);
  bool* forceStopFlag() const { return _forceStopFlag; }
  bool terminate() { return _forceStopFlag != nullptr && *_forceStopFlag; }

  /// The active vertices that may move, by Hessian index.
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
  /// Takes ownership; the algorithm that was there is deleted, during optimize() when that ends: the
  /// iteration that it is in goes on, and the next one is the first of the new algorithm, or none without
  /// one.
  void setAlgorithm(OptimizationAlgorithm* algorithm);
  void setAlgorithm(std::unique_ptr<OptimizationAlgorithm> algorithm);

  using OptimizableGraph::discardTop;
  using OptimizableGraph::pop;
  using OptimizableGraph::push;
  void push(VertexContainer& vlist);
  void push(HyperGraph::VertexSet& vlist) override;
  /// Of all active vertices.
  void push() override;
  void pop(VertexContainer& vlist);
  void pop(HyperGraph::VertexSet& vlist) override;
  void pop() override;
  void discardTop(VertexContainer& vlist);
  void discardTop() override;

  /// Removes vertices and edges; parameters and the algorithm stay.
  void clear() override;

  /// Calls computeError() of all active edges.
  void computeActiveErrors();
  G2O_ATTRIBUTE_DEPRECATED(void linearizeSystem()) {}

  /// Moves the vertices of indexMapping() by ⊞.
  void update(const double* update);

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

  OptimizationAlgorithm* _algorithm = nullptr;  ///< deleted with the optimizer
  BatchStatisticsContainer _batchStatistics;
  bool _computeBatchStatistics = false;

  void sortVectorContainers();
  /// Numbers the vertices that may move: marginalised ones last, each group in the given order.
  bool buildIndexMapping(SparseOptimizer::VertexContainer& vlist);
  void clearIndexMapping();

 private:
  friend class SparseOptimizerTerminateAction;
  friend class internal::BlockSolverEngine;
  /// What actions raise where the client gave no flag: they may go before the optimiser.
  bool own_stop_flag_ = false;
  /// Counts the changes of what takes part, and where.
  std::uint64_t structure_revision_ = 0;
  /// What the active vertices are mapped into: it outlives the solver, so that their hessian() stays
  /// readable.
  std::shared_ptr<const void> hessian_memory_;
  /// What several threads may work on; of an older structure where parts_revision_ says so.
  std::unique_ptr<internal::EdgeParts> edge_parts_;
  std::uint64_t parts_revision_ = 0;

  /// How many optimize() are under way, one within an action of the other; until the last one ends,
  /// algorithms that were replaced are kept.
  int optimize_depth_ = 0;
  std::vector<std::unique_ptr<OptimizationAlgorithm>> replaced_algorithms_;
  class OptimizeScope;

  internal::EdgeParts& edgeParts();
  void dropIncompleteEdges();
  bool startOptimization();
  void sizeWorkspace();
  void forgetInitialization();
  void writeVerboseLine(const OptimizationAlgorithm& algorithm, int iteration, double seconds,
                        double total) const;
};

}  // namespace g2o

#endif  // G2O_GRAPH_OPTIMIZER_CHOL_H_
