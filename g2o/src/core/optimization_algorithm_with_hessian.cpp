// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_with_hessian.h"

#include <algorithm>
#include <cmath>

#include "core/absent_solver.h"
#include "core/findings.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {
namespace {

/// Reports the first edge whose error is not finite. If all errors are finite, reports that a derivative is
/// not finite.
void report_edge(const SparseOptimizer& optimizer) {
  for (const OptimizableGraph::Edge* e : optimizer.activeEdges()) {
    if (std::isfinite(e->chi2())) continue;
    return G2O_ERROR("the error of the edge {} is not finite", internal::nameOf(*e));
  }
  G2O_ERROR("the derivatives of an error are not finite");
}

}  // namespace

OptimizationAlgorithmWithHessian::OptimizationAlgorithmWithHessian(Solver& solver)
    : _solver(solver), _writeDebug(_properties.makeProperty<Property<bool>>("writeDebug", true)) {}

OptimizationAlgorithmWithHessian::OptimizationAlgorithmWithHessian(Solver* solver)
    : OptimizationAlgorithmWithHessian(solver != nullptr ? *solver : *new internal::AbsentSolver) {
  owned_solver_.reset(&_solver);
}

OptimizationAlgorithmWithHessian::~OptimizationAlgorithmWithHessian() = default;

bool OptimizationAlgorithmWithHessian::init(bool online) {
  _solver.setWriteDebug(_writeDebug->value());
  const auto& vertices = _optimizer->indexMapping();
  const bool useSchur = _solver.supportsSchur() &&
                        std::any_of(vertices.begin(), vertices.end(),
                                    [](const OptimizableGraph::Vertex* v) { return v->marginalized(); });
  if (_solver.supportsSchur()) _solver.setSchur(useSchur);
  return _solver.init(_optimizer, online);
}

bool OptimizationAlgorithmWithHessian::computeMarginals(
    SparseBlockMatrix<MatrixX>& spinv, const std::vector<std::pair<int, int>>& blockIndices) {
  return _solver.computeMarginals(spinv, blockIndices);
}

bool OptimizationAlgorithmWithHessian::buildLinearStructure() {
  return _solver.buildStructure();
}

void OptimizationAlgorithmWithHessian::updateLinearSystem() {
  _solver.buildSystem();
}

bool OptimizationAlgorithmWithHessian::updateStructure(const std::vector<HyperGraph::Vertex*>& vset,
                                                       const HyperGraph::EdgeSet& edges) {
  return _solver.updateStructure(vset, edges);
}

void OptimizationAlgorithmWithHessian::setWriteDebug(bool writeDebug) {
  _writeDebug->setValue(writeDebug);
}

bool OptimizationAlgorithmWithHessian::linearize(int iteration, bool online) {
  if (iteration == 0 && !online && !_solver.buildStructure()) {
    G2O_ERROR("the structure of the linear system could not be built");
    return false;
  }
  G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats();
  {
    const internal::AddedTime time(statistics ? &statistics->timeResiduals : nullptr);
    if (_solver.computesErrors()) {
      _optimizer->postponeActiveErrors();
    } else {
      _optimizer->computeActiveErrors();
    }
  }
  const internal::AddedTime time(statistics ? &statistics->timeQuadraticForm : nullptr);
  _solver.buildSystem();
  if (_optimizer->errors_postponed_ || _optimizer->lost_vertices_) {  // buildSystem() found a lost vertex
    _optimizer->computeActiveErrors();
    _solver.buildSystem();
  }
  if (_solver.b() == nullptr) return true;
  const Eigen::Map<const VectorX> b(_solver.b(), static_cast<Eigen::Index>(_solver.vectorSize()));
  return reportUnlessFinite(b.allFinite());
}

double OptimizationAlgorithmWithHessian::linearizedChi2() const {
  return _solver.computesErrors() ? _optimizer->robustChi2OfPass() : _optimizer->activeRobustChi2();
}

double OptimizationAlgorithmWithHessian::computeRobustChi2() {
  _optimizer->computeActiveErrors();
  return _optimizer->robustChi2OfPass();
}

bool OptimizationAlgorithmWithHessian::reportUnlessFinite(bool finite) const {
  if (!finite) report_edge(*_optimizer);
  return finite;
}

bool OptimizationAlgorithmWithHessian::solveSystem() {
  G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats();
  const internal::AddedTime time(statistics ? &statistics->timeLinearSolution : nullptr);
  return _solver.solve();
}

bool OptimizationAlgorithmWithHessian::solveDamped(double lambda) {
  _solver.setLambda(lambda, true);
  bool solved = false;
  try {
    solved = solveSystem();
  } catch (...) {
    _solver.restoreDiagonal();
    throw;
  }
  _solver.restoreDiagonal();
  return solved;
}

}  // namespace g2o
