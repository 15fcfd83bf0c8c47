// SPDX-License-Identifier: BSD-3-Clause
// The base class of the library's linear solvers. It solves systems by the engine (the library boxplus).
#pragma once
#ifndef G2O_ENGINE_LINEAR_SOLVER_H
#define G2O_ENGINE_LINEAR_SOLVER_H

#include <utility>
#include <vector>

#include "g2o/core/linear_solver.h"

namespace g2o {
namespace internal {

template <typename MatrixType>
class EngineLinearSolver : public LinearSolverCCS<MatrixType> {
 public:
  explicit EngineLinearSolver(EngineSolver kind) : settings_{kind}, engine_(settings_) {}

  bool init() override {
    engine_.reset();
    return true;
  }
  bool solve(const SparseBlockMatrix<MatrixType>& A, double* x, double* b) override {
    engine_.setSettings(settings());
    return engine_.factorize(A) && engine_.solve(b, x);
  }
  EngineSettings engine() const override { return settings(); }

 protected:
  EngineSettings settings() const {
    EngineSettings settings = settings_;
    if (settings.solver == EngineSolver::kCholesky && !this->blockOrdering())
      settings.solver = EngineSolver::kScalarCholesky;
    return settings;
  }
  bool inverseBlocks(double**& blocks, const SparseBlockMatrix<MatrixType>& A) {
    engine_.setSettings(settings());
    if (!engine_.factorize(A)) return false;
    if (blocks == nullptr) this->allocateBlocks(A, blocks);
    std::vector<std::pair<int, int>> diagonal;
    for (int i = 0; i < static_cast<int>(A.rowBlockIndices().size()); ++i) diagonal.emplace_back(i, i);
    return engine_.inverse(diagonal, [&](size_t i, const MatrixX& block) {
      std::copy(block.data(), block.data() + block.size(), blocks[i]);
    });
  }
  bool inversePattern(SparseBlockMatrix<MatrixX>& spinv, const std::vector<std::pair<int, int>>& blockIndices,
                      const SparseBlockMatrix<MatrixType>& A) {
    engine_.setSettings(settings());
    if (!engine_.factorize(A)) return false;
    std::vector<int> dims;
    for (int i = 0; i < static_cast<int>(A.rowBlockIndices().size()); ++i) dims.push_back(A.rowsOfBlock(i));
    return fillInverse(engine_, dims, blockIndices, spinv);
  }

  EngineSettings settings_;
  LinearEngine engine_;
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_ENGINE_LINEAR_SOLVER_H
