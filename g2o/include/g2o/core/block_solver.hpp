// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BLOCK_SOLVER_HPP
#define G2O_BLOCK_SOLVER_HPP

#include "g2o/core/block_solver.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {

template <typename Traits>
bool BlockSolver<Traits>::init(SparseOptimizer* optimizer, bool online) {
  this->_optimizer = optimizer;
  lambda_ = 0;
  if (_linearSolver != nullptr) return online || _linearSolver->init();
  G2O_ERROR("the block solver has no linear solver");
  return false;
}

template <typename Traits>
bool BlockSolver<Traits>::computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                                           const std::vector<std::pair<int, int>>& blockIndices) {
  if (this->_optimizer != nullptr && engine_.isLinearized(*this->_optimizer))
    return engine_.inverse(blockIndices, spinv);
  G2O_ERROR("computeMarginals: the active vertices or edges have changed: call optimize() first");
  return false;
}

template <typename Traits>
bool BlockSolver<Traits>::buildStructure(bool) {
  if (this->_optimizer == nullptr || this->_optimizer->indexMapping().empty()) return false;
  for (const OptimizableGraph::Vertex* v : this->_optimizer->indexMapping()) {
    const bool fits =
        LandmarkDim == Eigen::Dynamic || !_doSchur || !v->marginalized() || v->dimension() == LandmarkDim;
    if (!fits) {
      G2O_ERROR("vertex {}: this block solver marginalizes only vertices with {} dimensions, got {}", v->id(),
                static_cast<int>(LandmarkDim), v->dimension());
      return false;
    }
  }
  _Hschur.reset();
  if (!engine_.buildStructure(*this->_optimizer, _doSchur, engineSettings())) return false;
  this->resizeVector(engine_.scalars());
  return true;
}

template <typename Traits>
internal::EngineSettings BlockSolver<Traits>::engineSettings() const {
  internal::EngineSettings settings = _linearSolver->engine();
  settings.exact = settings.exact || !this->inexactSteps();
  settings.retries = retries();
  return settings;
}

template <typename Traits>
void BlockSolver<Traits>::copyHessian() {
  const std::vector<int> ends = engine_.blockEnds();
  _numPoses = engine_.keptBlocks();
  _numLandmarks = static_cast<int>(ends.size()) - _numPoses;
  _sizePoses = _numPoses == 0 ? 0 : ends[static_cast<size_t>(_numPoses - 1)];
  _sizeLandmarks = (ends.empty() ? 0 : ends.back()) - _sizePoses;
  const int* poses = ends.data();
  std::vector<int> landmarks(ends.begin() + _numPoses, ends.end());
  for (int& end : landmarks) end -= _sizePoses;
  _Hpp = std::make_unique<PoseHessianType>(poses, poses, _numPoses, _numPoses);
  _Hll =
      std::make_unique<LandmarkHessianType>(landmarks.data(), landmarks.data(), _numLandmarks, _numLandmarks);
  _Hpl = std::make_unique<PoseLandmarkHessianType>(poses, landmarks.data(), _numPoses, _numLandmarks);
  engine_.visitBlocks([&](int i, int j, const MatrixX& block) {
    if (j < _numPoses) {
      *_Hpp->block(i, j, true) = block;
    } else if (i < _numPoses) {
      *_Hpl->block(i, j - _numPoses, true) = block;
    } else {
      *_Hll->block(i - _numPoses, j - _numPoses, true) = block;
    }
  });
}

template <typename Traits>
bool BlockSolver<Traits>::solve() {
  if (this->_optimizer == nullptr || !engine_.isCurrent(*this->_optimizer)) return false;
  internal::EngineSettings settings = engineSettings();
  if (isDerived() && _numLandmarks > 0)
    settings.solver = internal::EngineSolver::kNone;  // makes the engine fill _Hschur
  return engine_.solve(lambda_, this->_b, this->_x, settings,
                       [this](const std::vector<int>& dims, const EngineBlocks& blocks, double* x,
                              double* b) { return solveByLinearSolver(dims, blocks, x, b); });
}

/// Creates _Hschur, the matrix for the linear solver. Called once per structure.
template <typename Traits>
bool BlockSolver<Traits>::layOutReducedMatrix(const std::vector<int>& dims, const EngineBlocks& blocks) {
  std::vector<int> ends;
  int end = 0;
  for (int dim : dims) {
    if (PoseDim != Eigen::Dynamic && dim != PoseDim) {
      G2O_ERROR("expected vertices with {} dimensions for this linear solver, got one with {}",
                static_cast<int>(PoseDim), dim);
      return false;
    }
    ends.push_back(end += dim);
  }
  const int n = static_cast<int>(ends.size());
  auto A = std::make_unique<PoseHessianType>(ends.data(), ends.data(), n, n);
  reduced_blocks_.clear();
  for (const internal::EngineBlock& block : blocks)
    reduced_blocks_.push_back(A->block(block.column, block.row, true));
  _Hschur = std::move(A);
  return true;
}

template <typename Traits>
bool BlockSolver<Traits>::solveByLinearSolver(const std::vector<int>& dims, const EngineBlocks& blocks,
                                              double* x, double* b) {
  if (_Hschur == nullptr && !layOutReducedMatrix(dims, blocks)) return false;
  PoseMatrixType* const* target = reduced_blocks_.data();
  for (const internal::EngineBlock& block : blocks) {
    PoseMatrixType& to = **target++;
    to = Eigen::Map<const PoseMatrixType>(block.values, to.cols(), to.rows()).transpose();
  }
  if (_linearSolver->solve(*_Hschur, x, b)) return true;
  const auto level = retries() ? logging::Level::kWarn : logging::Level::kError;
  logging::format_and_log(level,
                          "the linear solver could not solve the system: it may not be positive definite");
  return false;
}

}  // namespace g2o

#endif  // G2O_BLOCK_SOLVER_HPP
