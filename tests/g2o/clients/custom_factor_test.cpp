// SPDX-License-Identifier: BSD-3-Clause
// A client with its own linear solver, which works on compressed columns and also computes marginal
// covariances. The client registers algorithms that use this solver. A second client has a custom algorithm
// and a custom action that stops a run.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "g2o/core/linear_solver.h"
#include "g2o/core/marginal_covariance_cholesky.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/core/sparse_optimizer_terminate_action.h"

namespace g2o {

/// A linear solver with the sparse Cholesky factorization of Eigen, without an ordering.
template <typename MatrixType>
class LinearSolverCustomFactor : public LinearSolverCCS<MatrixType> {
 public:
  LinearSolverCustomFactor() : LinearSolverCCS<MatrixType>() {}
  bool init() override { return true; }
  bool solve(const SparseBlockMatrix<MatrixType>& A, double* x, double* b) override {
    if (!factorize(A)) return false;
    VectorX::MapType(x, _A.cols()) = _factor.solve(VectorX::ConstMapType(b, _A.cols()));
    return true;
  }

 protected:
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor>;

  bool solveBlocks_impl(const SparseBlockMatrix<MatrixType>& A,
                        std::function<void(MarginalCovarianceCholesky&)> compute) override {
    if (!factorize(A)) return false;
    Sparse L = _factor.matrixL();
    MarginalCovarianceCholesky mcc;
    mcc.setCholeskyFactor(static_cast<int>(L.cols()), L.outerIndexPtr(), L.innerIndexPtr(), L.valuePtr(),
                          nullptr);
    compute(mcc);
    return true;
  }

  /// Rebuilds the structure each time, because the blocks of A are at different addresses in each call.
  bool factorize(const SparseBlockMatrix<MatrixType>& A) {
    this->initMatrixStructure(A);
    _A.resize(A.rows(), A.cols());
    _A.resizeNonZeros(static_cast<Eigen::Index>(A.nonZeros()));
    _A.resizeNonZeros(this->_ccsMatrix->fillCCS(_A.outerIndexPtr(), _A.innerIndexPtr(), _A.valuePtr(), true));
    _factor.compute(Sparse(_A.transpose()));
    return _factor.info() == Eigen::Success;
  }

  Sparse _A;
  Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> _factor;
};

namespace {

template <int p, int l, bool blockorder>
std::unique_ptr<Solver> AllocateSolver() {
  auto linearSolver =
      g2o::make_unique<LinearSolverCustomFactor<typename BlockSolverPL<p, l>::PoseMatrixType>>();
  linearSolver->setBlockOrdering(blockorder);
  return g2o::make_unique<BlockSolverPL<p, l>>(std::move(linearSolver));
}

OptimizationAlgorithm* createSolver(const std::string& fullSolverName) {
  static const std::map<std::string, std::function<std::unique_ptr<Solver>()>> solver_factories{
      {"var_custom", &AllocateSolver<-1, -1, true>},
      {"fix3_2_custom", &AllocateSolver<3, 2, true>},
  };
  const std::string methodName = fullSolverName.substr(0, 2);
  const auto factory = solver_factories.find(fullSolverName.substr(3));
  if (factory == solver_factories.end()) return nullptr;
  if (methodName == "gn") return new OptimizationAlgorithmGaussNewton(factory->second());
  if (methodName == "lm") return new OptimizationAlgorithmLevenberg(factory->second());
  std::unique_ptr<BlockSolverBase> blockSolver(static_cast<BlockSolverBase*>(factory->second().release()));
  return new OptimizationAlgorithmDogleg(std::move(blockSolver));
}

}  // namespace

class CustomFactorCreator : public AbstractOptimizationAlgorithmCreator {
 public:
  explicit CustomFactorCreator(const OptimizationAlgorithmProperty& p)
      : AbstractOptimizationAlgorithmCreator(p) {}
  OptimizationAlgorithm* construct() override { return createSolver(property().name); }
};

G2O_REGISTER_OPTIMIZATION_LIBRARY(custom_factor)

G2O_REGISTER_OPTIMIZATION_ALGORITHM(gn_var_custom, new CustomFactorCreator(OptimizationAlgorithmProperty(
                                                       "gn_var_custom", "Gauss-Newton: custom factor",
                                                       "Custom", false, Eigen::Dynamic, Eigen::Dynamic)))
G2O_REGISTER_OPTIMIZATION_ALGORITHM(lm_var_custom, new CustomFactorCreator(OptimizationAlgorithmProperty(
                                                       "lm_var_custom", "Levenberg: custom factor", "Custom",
                                                       false, Eigen::Dynamic, Eigen::Dynamic)))
G2O_REGISTER_OPTIMIZATION_ALGORITHM(dl_var_custom, new CustomFactorCreator(OptimizationAlgorithmProperty(
                                                       "dl_var_custom", "Dogleg: custom factor", "Custom",
                                                       false, Eigen::Dynamic, Eigen::Dynamic)))
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    gn_fix3_2_custom, new CustomFactorCreator(OptimizationAlgorithmProperty("gn_fix3_2_custom", "fixed sizes",
                                                                            "Custom", true, 3, 2)))

}  // namespace g2o

G2O_USE_OPTIMIZATION_LIBRARY(custom_factor)

namespace {

using small_graph::add_square;

double optimum(g2o::OptimizationAlgorithm* algorithm) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  optimizer.setAlgorithm(algorithm);
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(30), 0);
  optimizer.computeActiveErrors();
  return optimizer.activeChi2();
}

TEST(CustomFactor, WorksInTheAlgorithmsThatTheClientRegisters) {
  const double expected = optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  for (const char* name : {"gn_var_custom", "lm_var_custom", "dl_var_custom", "gn_fix3_2_custom"}) {
    SCOPED_TRACE(name);
    g2o::OptimizationAlgorithmProperty property;
    g2o::OptimizationAlgorithm* algorithm =
        g2o::OptimizationAlgorithmFactory::instance()->construct(name, property);
    ASSERT_NE(algorithm, nullptr);
    EXPECT_EQ(property.type, "Custom");
    EXPECT_NEAR(optimum(algorithm), expected, 1e-8);
  }
}

TEST(CustomFactor, ComputesBlocksOfTheInverse) {
  const int ends[] = {3, 6, 9};
  g2o::SparseBlockMatrix<g2o::MatrixX> A(ends, ends, 3, 3);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(9, 9);
  const Eigen::MatrixXd m = Eigen::MatrixXd::Random(9, 9);
  dense = m * m.transpose() + Eigen::MatrixXd::Identity(9, 9);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r <= c; ++r) *A.block(r, c, true) = dense.block(3 * r, 3 * c, 3, 3);
  const Eigen::MatrixXd inverse = dense.inverse();
  g2o::LinearSolverCustomFactor<g2o::MatrixX> solver;
  solver.init();
  double** blocks = nullptr;
  ASSERT_TRUE(solver.solveBlocks(blocks, A));
  for (int i = 0; i < 3; ++i)
    EXPECT_LT((Eigen::Map<Eigen::Matrix3d>(blocks[i]) - inverse.block(3 * i, 3 * i, 3, 3)).norm(), 1e-9);
  solver.deallocateBlocks(A, blocks);
  g2o::SparseBlockMatrix<g2o::MatrixX> spinv;
  ASSERT_TRUE(solver.solvePattern(spinv, {{0, 2}}, A));
  EXPECT_LT((*spinv.block(0, 2) - inverse.block(0, 6, 3, 3)).norm(), 1e-9);
}

/// An algorithm that takes half of each Gauss-Newton step. It passes its solver to the base class as a raw
/// pointer, as in old versions of g2o.
class Cautious : public g2o::OptimizationAlgorithmWithHessian {
 public:
  explicit Cautious(g2o::Solver* solver) : OptimizationAlgorithmWithHessian(solver) {}
  SolverResult solve(int iteration, bool online = false) override {
    if (iteration == 0 && !online && !_solver.buildStructure()) return Fail;
    _optimizer->computeActiveErrors();
    _solver.buildSystem();
    if (!_solver.solve()) return Fail;
    std::vector<double> step(_solver.x(), _solver.x() + _solver.vectorSize());
    for (double& s : step) s /= 2;
    _optimizer->update(step.data());
    return OK;
  }
};

/// An action that stops a run when chi2 decreases by less than a given fraction, and records that it stopped
/// the run.
class Convergence : public g2o::SparseOptimizerTerminateAction {
 public:
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph* graph, Parameters* parameters = nullptr) override {
    const g2o::SparseOptimizer* optimizer = static_cast<const g2o::SparseOptimizer*>(graph);
    const_cast<g2o::SparseOptimizer*>(optimizer)->computeActiveErrors();
    const int iteration = static_cast<g2o::HyperGraphAction::ParametersIteration*>(parameters)->iteration;
    const double chi = optimizer->activeRobustChi2();
    if (iteration < 0) {
      setOptimizerStopFlag(optimizer, false);
    } else if (iteration > 0) {
      const double gain = (_lastChi - chi) / chi;
      stopped = (gain >= 0 && gain < _gainThreshold) || iteration >= _maxIterations;
      if (stopped) setOptimizerStopFlag(optimizer, true);
    }
    _lastChi = chi;
    return this;
  }
  bool stopped = false;
};

TEST(CustomAlgorithm, StopsIfACustomActionSetsTheStopFlag) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  optimizer.setAlgorithm(new Cautious(small_graph::make_solver().release()));
  auto* action = new Convergence;
  action->setGainThreshold(1e-8);
  optimizer.addPostIterationAction(action);
  ASSERT_TRUE(optimizer.initializeOptimization());
  const int iterations = optimizer.optimize(200);
  EXPECT_TRUE(action->stopped);
  EXPECT_GT(iterations, 5);
  EXPECT_LT(iterations, 100);
  optimizer.removePostIterationAction(action);
  delete action;
  EXPECT_EQ(optimizer.optimize(20), 20);
  optimizer.computeActiveErrors();
  EXPECT_NEAR(optimizer.activeChi2(),
              optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver())), 1e-6);
}

}  // namespace
