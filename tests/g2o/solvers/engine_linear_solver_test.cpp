// SPDX-License-Identifier: BSD-3-Clause
// Tests of the linear solvers of the library, alone and inside a BlockSolver.
#include <gmock/gmock.h>

#include <memory>

#include "g2o/core/small_graph.h"
#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/solvers/pcg/linear_solver_pcg.h"

namespace {

using small_graph::add_square;
using Matrix = g2o::SparseBlockMatrix<g2o::MatrixX>;
using Pcg = g2o::LinearSolverPCG<g2o::MatrixX>;
using Eigens = g2o::LinearSolverEigen<g2o::MatrixX>;
using Cholmod = g2o::LinearSolverCholmod<g2o::MatrixX>;

/// The upper triangle of a symmetric block-tridiagonal matrix with n × n blocks of 2 × 2.
Matrix chain(int n) {
  std::vector<int> ends;
  for (int i = 1; i <= n; ++i) ends.push_back(2 * i);
  Matrix A(ends.data(), ends.data(), n, n);
  for (int i = 0; i < n; ++i) {
    *A.block(i, i, true) = Eigen::Matrix2d{{3, 0.5}, {0.5, 4}};
    if (i > 0) *A.block(i - 1, i, true) = Eigen::Matrix2d{{-1, 0.25}, {-0.5, -1}};
  }
  return A;
}

Eigen::VectorXd residual(const Matrix& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(b.size());
  double* out = product.data();
  A.multiplySymmetricUpperTriangle(out, x.data());
  return b - product;
}

template <class Solver>
Eigen::VectorXd solved(Solver& solver, const Matrix& A, const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), copy = b;
  EXPECT_TRUE(solver.init());
  EXPECT_TRUE(solver.solve(A, x.data(), copy.data()));
  return x;
}

TEST(LinearSolvers, PcgStopsAtItsAbsoluteOrItsRelativeTolerance) {
  const Matrix A = chain(50);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(100, 1, 2) * 1e-4;
  Pcg pcg;
  pcg.setTolerance(1e-5);
  EXPECT_TRUE(pcg.absoluteTolerance());
  const double absolute = residual(A, solved(pcg, A, b), b).norm();
  pcg.setAbsoluteTolerance(false);
  const double relative = residual(A, solved(pcg, A, b), b).norm();
  EXPECT_LE(absolute, 1e-5);
  EXPECT_LE(relative, 1e-5 * b.norm());
  EXPECT_GT(absolute, 10 * relative);
}

TEST(LinearSolvers, PcgNeedsFewerIterationsWithAnAbsoluteToleranceIfTheInformationIsSmall) {
  std::vector<int> iterations;
  for (const bool absolute : {true, false}) {
    g2o::SparseOptimizer optimizer;
    add_square(optimizer);
    for (g2o::HyperGraph::Edge* e : optimizer.edges())
      static_cast<g2o::EdgeSE2*>(e)->setInformation(Eigen::Matrix3d::Identity() * 1e-4);
    auto pcg = std::make_unique<Pcg>();
    pcg->setTolerance(1e-4);
    pcg->setAbsoluteTolerance(absolute);
    optimizer.setAlgorithm(
        new g2o::OptimizationAlgorithmGaussNewton(std::make_unique<g2o::BlockSolverX>(std::move(pcg))));
    optimizer.setComputeBatchStatistics(true);
    optimizer.initializeOptimization();
    EXPECT_EQ(optimizer.optimize(1), 1);
    iterations.push_back(optimizer.batchStatistics()[0].iterationsLinearSolver);
  }
  EXPECT_LT(iterations[0], iterations[1]);
}

TEST(LinearSolvers, BlockAndScalarOrderingsGiveTheSameSolution) {
  const Matrix A = chain(50);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(100, 1, 2);
  Eigens solver;
  EXPECT_TRUE(solver.blockOrdering());
  EXPECT_EQ(solver.engine().solver, g2o::internal::EngineSolver::kCholesky);
  const Eigen::VectorXd by_blocks = solved(solver, A, b);
  solver.setBlockOrdering(false);
  EXPECT_EQ(solver.engine().solver, g2o::internal::EngineSolver::kScalarCholesky);
  const Eigen::VectorXd by_scalars = solved(solver, A, b);
  EXPECT_LT((by_blocks - by_scalars).norm(), 1e-12 * by_blocks.norm());
  Matrix one, other;
  ASSERT_TRUE(solver.solvePattern(one, {{0, 0}, {0, 1}}, A));
  solver.setBlockOrdering(true);
  ASSERT_TRUE(solver.solvePattern(other, {{0, 0}, {0, 1}}, A));
  EXPECT_LT((*one.block(0, 1) - *other.block(0, 1)).norm(), 1e-12);
}

TEST(LinearSolvers, BlockAndScalarOrderingsFindTheSameMinimum) {
  std::vector<double> chi2;
  for (const bool blocks : {true, false}) {
    g2o::SparseOptimizer optimizer;
    add_square(optimizer);
    auto linear = std::make_unique<Eigens>();
    linear->setBlockOrdering(blocks);
    optimizer.setAlgorithm(
        new g2o::OptimizationAlgorithmGaussNewton(std::make_unique<g2o::BlockSolverX>(std::move(linear))));
    optimizer.initializeOptimization();
    EXPECT_EQ(optimizer.optimize(10), 10);
    optimizer.computeActiveErrors();
    chi2.push_back(optimizer.activeChi2());
  }
  EXPECT_NEAR(chi2[0], chi2[1], 1e-12);
}

/// chain(n), but every third block row has the weight 1e6, and every third diagonal block is 0, like that of
/// a Lagrange multiplier.
Matrix indefinite_chain(int n) {
  Matrix A = chain(n);
  for (int i = 0; i < n; ++i) {
    if (i % 3 == 0) *A.block(i, i) *= 1e6;
    if (i % 3 == 1) A.block(i, i)->setZero();
  }
  return A;
}

TEST(LinearSolvers, OnlyCholmodSolvesIndefiniteSystems) {
  const Matrix A = indefinite_chain(60);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(120, 1, 2);
  for (const bool blocks : {true, false}) {
    Cholmod cholmod;
    cholmod.setBlockOrdering(blocks);
    EXPECT_LT(residual(A, solved(cholmod, A, b), b).norm(), 1e-9 * b.norm());
    Matrix inverse;
    ASSERT_TRUE(cholmod.solvePattern(inverse, {{0, 0}, {0, 1}}, A));
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(120);
    unit[0] = 1;
    const Eigen::VectorXd column = solved(cholmod, A, unit);
    EXPECT_LT((inverse.block(0, 1)->row(0).transpose() - column.segment<2>(2)).norm(), 1e-12);
  }
  Eigens eigen;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(120), copy = b;
  EXPECT_FALSE(eigen.solve(A, x.data(), copy.data()));
}

TEST(LinearSolvers, CholmodRefusesSingularSystems) {
  Matrix A = indefinite_chain(4);
  *A.block(3, 3) = Eigen::Matrix2d{{1, 2}, {2, 4}};
  A.block(2, 3)->setZero();
  Eigen::VectorXd b = Eigen::VectorXd::Ones(8), x = Eigen::VectorXd::Zero(8);
  Cholmod cholmod;
  EXPECT_FALSE(cholmod.solve(A, x.data(), b.data()));
  EXPECT_EQ(x, Eigen::VectorXd::Zero(8));
}

}  // namespace
