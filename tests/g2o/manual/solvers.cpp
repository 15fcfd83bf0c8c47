// SPDX-License-Identifier: BSD-3-Clause
// A library that registers algorithms with the macros of listing 2 of the g2o document.
#include <memory>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace g2o {
namespace {

template <class Algorithm, int P, int L>
OptimizationAlgorithm* create() {
  using Blocks = BlockSolverPL<P, L>;
  return new Algorithm(
      std::make_unique<Blocks>(std::make_unique<LinearSolverEigen<typename Blocks::PoseMatrixType>>()));
}

class ManualSolverCreator : public AbstractOptimizationAlgorithmCreator {
 public:
  explicit ManualSolverCreator(const OptimizationAlgorithmProperty& p)
      : AbstractOptimizationAlgorithmCreator(p) {}
  virtual OptimizationAlgorithm* construct() {
    if (property().name == "gn_manual") return create<OptimizationAlgorithmGaussNewton, -1, -1>();
    if (property().name == "lm_manual") return create<OptimizationAlgorithmLevenberg, -1, -1>();
    if (property().name == "gn_manual3_2") return create<OptimizationAlgorithmGaussNewton, 3, 2>();
    return nullptr;
  }
};

}  // namespace

G2O_REGISTER_OPTIMIZATION_LIBRARY(manual);

G2O_REGISTER_OPTIMIZATION_ALGORITHM(gn_manual, new ManualSolverCreator(OptimizationAlgorithmProperty(
                                                   "gn_manual", "Gauss-Newton: any sizes of blocks", "Eigen",
                                                   false, Eigen::Dynamic, Eigen::Dynamic)));
G2O_REGISTER_OPTIMIZATION_ALGORITHM(lm_manual, new ManualSolverCreator(OptimizationAlgorithmProperty(
                                                   "lm_manual", "Levenberg: any sizes of blocks", "Eigen",
                                                   false, Eigen::Dynamic, Eigen::Dynamic)));
G2O_REGISTER_OPTIMIZATION_ALGORITHM(gn_manual3_2, new ManualSolverCreator(OptimizationAlgorithmProperty(
                                                      "gn_manual3_2", "Gauss-Newton: poses of 3, points of 2",
                                                      "Eigen", true, 3, 2)));
}  // namespace g2o
