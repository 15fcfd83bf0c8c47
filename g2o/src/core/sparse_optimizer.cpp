// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/sparse_optimizer.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <set>

#include "core/findings.h"
#include "core/prefetch.h"
#include "engine/edge_parts.h"
#include "g2o/core/estimate_propagator.h"
#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/robust_kernel.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {
namespace {

OptimizableGraph::Vertex* as_vertex(HyperGraph::Vertex* v) {
  return static_cast<OptimizableGraph::Vertex*>(v);
}

/// Clears the thread's statistics pointer. The destructor restores the pointer, even if optimize() ends with
/// an exception.
class StatisticsScope {
 public:
  StatisticsScope() : before_(G2OBatchStatistics::globalStats()) {
    G2OBatchStatistics::setGlobalStats(nullptr);
  }
  ~StatisticsScope() { G2OBatchStatistics::setGlobalStats(before_); }
  StatisticsScope(const StatisticsScope&) = delete;
  StatisticsScope& operator=(const StatisticsScope&) = delete;

 private:
  G2OBatchStatistics* before_;
};

/// Saves the estimates of vertices. The destructor restores them.
class Restored {
 public:
  Restored() = default;
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;
  ~Restored() {
    for (OptimizableGraph::Vertex* v : vertices_) {
      try {
        v->pop();
      } catch (...) {  // thrown by client code; the other vertices are still restored
      }
    }
  }
  void add(OptimizableGraph::Vertex* v) {
    vertices_.push_back(v);
    try {
      v->push();
    } catch (...) {
      vertices_.pop_back();
      throw;
    }
  }

 private:
  std::vector<OptimizableGraph::Vertex*> vertices_;
};

}  // namespace

SparseOptimizer::SparseOptimizer() {
  _graphActions.resize(AT_NUM_ELEMENTS);
}

SparseOptimizer::~SparseOptimizer() {
  delete _algorithm;
}

void SparseOptimizer::computeInitialGuess() {
  EstimatePropagatorCost propagator(this);
  computeInitialGuess(propagator);
}

void SparseOptimizer::computeInitialGuess(EstimatePropagatorCost& propagator) {
  OptimizableGraph::VertexSet known, seen;
  Restored outside;
  for (HyperGraph::Edge* e : edges()) {
    for (HyperGraph::Vertex* u : e->vertices()) {
      if (u == nullptr) continue;
      OptimizableGraph::Vertex* v = as_vertex(u);
      if (v->fixed()) {
        known.insert(v);
      } else if (v->hessianIndex() == -1 && seen.insert(v).second) {
        outside.add(v);
      }
    }
  }
  dropIncompleteEdges();
  const OptimizableGraph::VertexSet nothing;
  for (OptimizableGraph::Edge* edge : _activeEdges) {
    if (edge->vertices().size() != 1) continue;
    OptimizableGraph::Vertex* v = as_vertex(edge->vertex(0));
    if (edge->initialEstimatePossible(nothing, v) > 0) {
      edge->initialEstimate(nothing, v);
      known.insert(v);
    }
  }
  EstimatePropagator(this).propagate(known, propagator);
}

void SparseOptimizer::setToOrigin() {
  for (const auto& [id, v] : vertices()) as_vertex(v)->setToOrigin();
}

/// Keeps replaced algorithms alive until the outermost call of optimize() returns.
class SparseOptimizer::OptimizeScope {
 public:
  explicit OptimizeScope(SparseOptimizer& optimizer) : optimizer_(optimizer) { ++optimizer_.optimize_depth_; }
  OptimizeScope(const OptimizeScope&) = delete;
  OptimizeScope& operator=(const OptimizeScope&) = delete;
  ~OptimizeScope() {
    if (--optimizer_.optimize_depth_ == 0) optimizer_.replaced_algorithms_.clear();
  }

 private:
  SparseOptimizer& optimizer_;
};

int SparseOptimizer::optimize(int iterations, bool online) {
  if (_ivMap.empty()) {
    G2O_ERROR(
        "optimize: no vertices to optimize; was initializeOptimization() called? (Call it again after "
        "removing a vertex.)");
    return -1;
  }
  if (_algorithm == nullptr) {
    G2O_ERROR("optimize: no algorithm was set");
    return -1;
  }
  if (!_algorithm->init(online)) {
    G2O_ERROR("optimize: the algorithm could not be initialized");
    return -1;
  }
  own_stop_flag_ = false;
  const OptimizeScope keep_algorithms(*this);
  for (const OptimizableGraph::Edge* e : _activeEdges) {
    if (e->numUndefinedVertices() == 0) continue;
    G2O_ERROR("optimize: an edge has lost a vertex since initializeOptimization()");
    return -1;
  }
  _batchStatistics.clear();
  const StatisticsScope scope;
  OptimizationAlgorithm::SolverResult result = OptimizationAlgorithm::OK;
  double total = 0;
  OptimizationAlgorithm* algorithm = _algorithm;
  int done = 0, first_of_algorithm = 0;
  for (; done < iterations && !terminate() && result == OptimizationAlgorithm::OK; ++done) {
    preIteration(done);
    if (_algorithm == nullptr) break;  // an action removed the algorithm
    if (_algorithm != algorithm) {
      algorithm = _algorithm;
      first_of_algorithm = done;
      if (!algorithm->init(online)) {
        G2O_ERROR(
            "optimize: an action replaced the algorithm, but the new algorithm could not be initialized");
        return 0;
      }
    }
    if (_computeBatchStatistics) {
      _batchStatistics.emplace_back();
      G2OBatchStatistics& statistics = _batchStatistics.back();
      G2OBatchStatistics::setGlobalStats(&statistics);
      statistics.iteration = done;
      statistics.numEdges = static_cast<int>(_activeEdges.size());
      statistics.numVertices = static_cast<int>(_activeVertices.size());
      for (const OptimizableGraph::Vertex* v : _ivMap) {
        const auto dim = static_cast<size_t>(v->dimension());
        statistics.hessianDimension += dim;
        (v->marginalized() ? statistics.hessianLandmarkDimension : statistics.hessianPoseDimension) += dim;
      }
    }
    const double begin = get_monotonic_time();
    result = algorithm->solve(done - first_of_algorithm, online);
    const double seconds = get_monotonic_time() - begin;
    total += seconds;
    if (_computeBatchStatistics || _verbose) computeActiveErrors();
    if (_computeBatchStatistics) {
      _batchStatistics.back().chi2 = activeRobustChi2();
      _batchStatistics.back().timeIteration = seconds;
    }
    if (_verbose) writeVerboseLine(*algorithm, done, seconds, total);
    postIteration(done);
  }
  const bool has_failed = result == OptimizationAlgorithm::Fail;
  if (_verbose && (has_failed || !std::isfinite(activeRobustChi2()))) internal::reportFindings(*this);
  return has_failed ? 0 : done;
}

void SparseOptimizer::writeVerboseLine(const OptimizationAlgorithm& algorithm, int iteration, double seconds,
                                       double total) const {
  std::cerr << "iteration= " << iteration << "\t chi2= " << std::fixed << activeRobustChi2()
            << "\t time= " << seconds << "\t cumTime= " << total << "\t edges= " << _activeEdges.size();
  algorithm.printVerbose(std::cerr);
  std::cerr << std::defaultfloat << '\n';
}

bool SparseOptimizer::computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                                       const std::vector<std::pair<int, int>>& blockIndices) {
  if (_algorithm == nullptr || _ivMap.empty()) {
    G2O_ERROR("computeMarginals: expected an optimizer whose algorithm has run");
    return false;
  }
  const internal::AddedTime time(_batchStatistics.empty() ? nullptr : &_batchStatistics.back().timeMarginals);
  return _algorithm->computeMarginals(spinv, blockIndices);
}

bool SparseOptimizer::computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const Vertex* vertex) {
  if (vertex == nullptr || vertex->hessianIndex() < 0) {
    G2O_ERROR("computeMarginals: expected a vertex that takes part in the optimization");
    return false;
  }
  return computeMarginals(spinv,
                          std::vector<std::pair<int, int>>{{vertex->hessianIndex(), vertex->hessianIndex()}});
}

bool SparseOptimizer::computeMarginals(SparseBlockMatrix<MatrixX>& spinv, const VertexContainer& vertices) {
  std::vector<std::pair<int, int>> indices;
  for (const Vertex* v : vertices) {
    const int index = v == nullptr ? -1 : v->hessianIndex();
    indices.emplace_back(index, index);
  }
  return computeMarginals(spinv, indices);
}

OptimizableGraph::Vertex* SparseOptimizer::findGauge() {
  if (vertices().empty()) return nullptr;
  const int largest = maxDimension();
  OptimizableGraph::Vertex* best = nullptr;
  for (const auto& [id, u] : vertices()) {
    OptimizableGraph::Vertex* v = as_vertex(u);
    if (v->dimension() == largest && (best == nullptr || v->id() < best->id())) best = v;
  }
  return best;
}

bool SparseOptimizer::gaugeFreedom() {
  if (vertices().empty()) return false;
  const int largest = maxDimension();
  for (const auto& [id, u] : vertices()) {
    const OptimizableGraph::Vertex* v = as_vertex(u);
    if (v->dimension() != largest) continue;
    if (v->fixed()) return false;
    for (const HyperGraph::Edge* e : v->edges()) {
      if (e->vertices().size() == 1 && static_cast<const Edge*>(e)->dimension() >= largest) return false;
    }
  }
  return true;
}

double SparseOptimizer::activeChi2() const {
  double sum = 0;
  for (const OptimizableGraph::Edge* e : _activeEdges) sum += e->chi2();
  return sum;
}

double SparseOptimizer::activeRobustChi2() const {
  double sum = 0;
  for (const OptimizableGraph::Edge* e : _activeEdges) {
    if (e->robustKernel() == nullptr) {
      sum += e->chi2();
    } else {
      Vector3 rho;
      e->robustKernel()->robustify(e->chi2(), rho);
      sum += rho[0];
    }
  }
  return sum;
}

void SparseOptimizer::setVerbose(bool verbose) {
  _verbose = verbose;
}

void SparseOptimizer::setForceStopFlag(bool* flag) {
  _forceStopFlag = flag;
}

void SparseOptimizer::setAlgorithm(OptimizationAlgorithm* algorithm) {
  if (algorithm != _algorithm) {
    std::unique_ptr<OptimizationAlgorithm> before(_algorithm);
    for (auto& replaced : replaced_algorithms_) {
      if (replaced.get() == algorithm) static_cast<void>(replaced.release());  // now the current algorithm
    }
    _algorithm = algorithm;
    if (optimize_depth_ > 0 && before != nullptr) replaced_algorithms_.push_back(std::move(before));
  }
  if (_algorithm != nullptr) _algorithm->setOptimizer(this);
}

void SparseOptimizer::setAlgorithm(std::unique_ptr<OptimizationAlgorithm> algorithm) {
  setAlgorithm(algorithm.release());
}

void SparseOptimizer::push(VertexContainer& vlist) {
  size_t pushed = 0;
  try {
    internal::for_each_ahead(vlist, [&](Vertex& v) {
      v.push();
      ++pushed;
    });
  } catch (...) {
    while (pushed > 0) vlist[--pushed]->discardTop();
    throw;
  }
}

void SparseOptimizer::pop(VertexContainer& vlist) {
  internal::for_each_ahead(vlist, [](Vertex& v) { v.pop(); });
}

void SparseOptimizer::discardTop(VertexContainer& vlist) {
  internal::for_each_ahead(vlist, [](Vertex& v) { v.discardTop(); });
}

void SparseOptimizer::push(HyperGraph::VertexSet& vlist) {
  OptimizableGraph::push(vlist);
}

void SparseOptimizer::pop(HyperGraph::VertexSet& vlist) {
  OptimizableGraph::pop(vlist);
}

void SparseOptimizer::push() {
  push(_activeVertices);
}

void SparseOptimizer::pop() {
  pop(_activeVertices);
}

void SparseOptimizer::discardTop() {
  discardTop(_activeVertices);
}

void SparseOptimizer::clear() {
  ++structure_revision_;
  _ivMap.clear();
  _activeVertices.clear();
  _activeEdges.clear();
  HyperGraph::clear();
}

internal::EdgeParts& SparseOptimizer::edgeParts() {
  if (!edge_parts_) edge_parts_ = std::make_unique<internal::EdgeParts>();
  if (parts_revision_ != structure_revision_ || !edge_parts_->is_of(_activeEdges)) {
    edge_parts_->part(_activeEdges, static_cast<int>(_ivMap.size()));
    parts_revision_ = structure_revision_;
  }
  return *edge_parts_;
}

void SparseOptimizer::computeActiveErrors() {
  callActions(AT_COMPUTEACTIVERROR);
  errors_postponed_ = false;
  lost_vertices_ = edgeParts().compute_errors(true);
  if (lost_vertices_) dropIncompleteEdges();
}

void SparseOptimizer::postponeActiveErrors() {
  callActions(AT_COMPUTEACTIVERROR);
  lost_vertices_ = false;
  if (edgeParts().compute_errors(false)) dropIncompleteEdges();
  errors_postponed_ = true;
}

double SparseOptimizer::robustChi2OfPass() const {
  return lost_vertices_ || edge_parts_ == nullptr ? activeRobustChi2() : edge_parts_->robust_chi2_of_pass();
}

void SparseOptimizer::update(const double* update) {
  if (update == nullptr) {
    G2O_ERROR("update: expected a step, got nullptr");
    return;
  }
  G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats();
  const internal::AddedTime time(statistics ? &statistics->timeUpdate : nullptr);
  internal::for_each_ahead(_ivMap, [&](OptimizableGraph::Vertex& v) {
    v.oplus(update);
    update += v.dimension();
  });
}

void SparseOptimizer::setComputeBatchStatistics(bool computeBatchStatistics) {
  _computeBatchStatistics = computeBatchStatistics;
  if (!computeBatchStatistics) _batchStatistics.clear();
}

bool SparseOptimizer::addComputeErrorAction(HyperGraphAction* action) {
  return addAction(AT_COMPUTEACTIVERROR, action);
}

bool SparseOptimizer::removeComputeErrorAction(HyperGraphAction* action) {
  return _graphActions[AT_COMPUTEACTIVERROR].erase(action) > 0;
}

}  // namespace g2o
