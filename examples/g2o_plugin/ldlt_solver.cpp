// SPDX-License-Identifier: BSD-3-Clause
// A plug-in for the tool `g2o` with one algorithm: Levenberg-Marquardt with Eigen's sparse LDLᵀ
// factorization.
#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"

namespace example {

// [solver]
class LinearSolverLdlt : public g2o::LinearSolver<g2o::MatrixX> {
 public:
  bool init() override { return true; }
  bool solve(const g2o::SparseBlockMatrix<g2o::MatrixX>& A, double* x, double* b) override {
    std::vector<Eigen::Triplet<double>> entries;
    for (size_t c = 0; c < A.blockCols().size(); ++c) {
      for (const auto& [r, block] : A.blockCols()[c]) {
        const int row = A.rowBaseOfBlock(r), column = A.colBaseOfBlock(static_cast<int>(c));
        for (int i = 0; i < block->rows(); ++i)
          for (int j = 0; j < block->cols(); ++j) entries.emplace_back(row + i, column + j, (*block)(i, j));
      }
    }
    Eigen::SparseMatrix<double> matrix(A.rows(), A.cols());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> factor(matrix);
    if (factor.info() != Eigen::Success) return false;
    Eigen::Map<Eigen::VectorXd>(x, A.cols()) = factor.solve(Eigen::Map<Eigen::VectorXd>(b, A.cols()));
    return true;
  }
};
// [/solver]

// [register]
class Creator : public g2o::AbstractOptimizationAlgorithmCreator {
 public:
  using g2o::AbstractOptimizationAlgorithmCreator::AbstractOptimizationAlgorithmCreator;
  g2o::OptimizationAlgorithm* construct() override {
    return new g2o::OptimizationAlgorithmLevenberg(
        std::make_unique<g2o::BlockSolverX>(std::make_unique<LinearSolverLdlt>()));
  }
};

G2O_REGISTER_OPTIMIZATION_LIBRARY(ldlt)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(lm_ldlt, new Creator(g2o::OptimizationAlgorithmProperty(
                                                 "lm_ldlt", "Levenberg-Marquardt: Eigen's sparse LDLT",
                                                 "LDLT", false, -1, -1)))
// [/register]

}  // namespace example
