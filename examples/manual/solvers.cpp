// SPDX-License-Identifier: BSD-3-Clause
// Solves one graph in several ways. Each way combines an algorithm, a Solver and a LinearSolver.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/core/sparse_optimizer_terminate_action.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/solvers/pcg/linear_solver_pcg.h"
#include "g2o/types/slam2d/types_slam2d.h"

// [use]
G2O_USE_OPTIMIZATION_LIBRARY(eigen)
// [/use]

using namespace g2o;

/// A robot drives twice along a square with 10 poses per side, and sees the landmarks near it. The
/// measurement errors are deterministic, but about as large as typical noise.
void add_graph(SparseOptimizer& optimizer) {
  const auto wobble = [](int i) { return 0.03 * std::sin(12.9898 * i); };
  for (int id = 0; id < 16; ++id) {
    auto* v = new VertexPointXY;
    v->setId(1000 + id);
    v->setEstimate(Vector2(-1 + 4 * (id % 4), -1 + 4 * (id / 4)));
    optimizer.addVertex(v);
  }
  SE2 truth, estimate;
  for (int id = 0; id < 80; ++id) {
    auto* v = new VertexSE2;
    v->setId(id);
    v->setEstimate(estimate);
    v->setFixed(id == 0);
    optimizer.addVertex(v);
    for (int l = 0; l < 16; ++l) {
      const Vector2 seen = truth.inverse() * Vector2(-1 + 4 * (l % 4), -1 + 4 * (l / 4));
      if (seen.norm() > 3) continue;
      auto* e = new EdgeSE2PointXY;
      e->setVertex(0, v);
      e->setVertex(1, optimizer.vertex(1000 + l));
      e->setMeasurement(seen + Vector2(wobble(3 * id + l), wobble(5 * id + l)));
      e->setInformation(Matrix2::Identity() * 1000);
      optimizer.addEdge(e);
    }
    const SE2 step(1, 0, id % 10 == 9 ? const_pi() / 2 : 0);
    truth *= step;
    estimate *= step * SE2(wobble(id), wobble(2 * id), wobble(7 * id) / 2);
    if (id == 0) continue;
    auto* e = new EdgeSE2;
    e->setVertex(0, optimizer.vertex(id - 1));
    e->setVertex(1, v);
    e->setMeasurement(SE2(1, 0, id % 10 == 0 ? const_pi() / 2 : 0));
    e->setInformation(Matrix3(Vector3(1000, 1000, 4000).asDiagonal()));
    optimizer.addEdge(e);
  }
}

void marginalize_landmarks(SparseOptimizer& optimizer) {
  // [marginalize]
  for (const auto& [id, v] : optimizer.vertices())
    if (auto* landmark = dynamic_cast<VertexPointXY*>(v)) landmark->setMarginalized(true);
  // [/marginalize]
}

double solve(const char* name, SparseOptimizer& optimizer) {
  optimizer.initializeOptimization();
  optimizer.setComputeBatchStatistics(true);
  const int iterations = optimizer.optimize(30);
  const auto& last = optimizer.batchStatistics().back();
  std::printf("%-36s chi2 = %.3f, %3zu unknowns in the linear system%s\n", name, last.chi2,
              optimizer.solver() != nullptr && last.hessianLandmarkDimension > 0 ? last.hessianPoseDimension
                                                                                 : last.hessianDimension,
              iterations > 0 ? "" : ", failed");
  return last.chi2;
}

int main() {
  double smallest = 1e300, largest = 0;
  const auto note = [&](double chi2) {
    smallest = std::min(smallest, chi2);
    largest = std::max(largest, chi2);
  };
  {
    // [parts]
    using Blocks = BlockSolverX;                               // blocks of any sizes
    using Linear = LinearSolverEigen<Blocks::PoseMatrixType>;  // sparse Cholesky
    auto algorithm = std::make_unique<OptimizationAlgorithmLevenberg>(
        std::make_unique<Blocks>(std::make_unique<Linear>()));
    algorithm->setUserLambdaInit(1e-3);
    SparseOptimizer optimizer;
    optimizer.setAlgorithm(std::move(algorithm));
    // [/parts]
    add_graph(optimizer);
    note(solve("Levenberg, Cholesky:", optimizer));
  }
  {
    // [schur]
    using Blocks = BlockSolver_3_2;  // poses have 3 dimensions, landmarks have 2
    SparseOptimizer optimizer;
    optimizer.setAlgorithm(new OptimizationAlgorithmGaussNewton(
        std::make_unique<Blocks>(std::make_unique<LinearSolverEigen<Blocks::PoseMatrixType>>())));
    add_graph(optimizer);
    marginalize_landmarks(optimizer);
    // [/schur]
    note(solve("Gauss-Newton, Schur, Cholesky:", optimizer));

    // [covariance]
    SparseBlockMatrix<MatrixX> covariance;
    const auto* pose = optimizer.vertex(40);
    if (!optimizer.computeMarginals(covariance, pose)) return 1;
    const MatrixX& block = *covariance.block(pose->hessianIndex(), pose->hessianIndex());
    std::printf("  standard deviation of x of pose 40: %.4f m\n", std::sqrt(block(0, 0)));
    // [/covariance]
  }
  {
    // [pcg]
    using Blocks = BlockSolverX;
    auto linear = std::make_unique<LinearSolverPCG<Blocks::PoseMatrixType>>();
    linear->setTolerance(1e-8);
    SparseOptimizer optimizer;
    optimizer.setAlgorithm(new OptimizationAlgorithmDogleg(std::make_unique<Blocks>(std::move(linear))));
    // [/pcg]
    add_graph(optimizer);
    note(solve("dogleg, conjugate gradients:", optimizer));
  }
  {
    // [factory]
    OptimizationAlgorithmProperty property;
    SparseOptimizer optimizer;
    optimizer.setAlgorithm(OptimizationAlgorithmFactory::instance()->construct("lm_fix3_2", property));
    add_graph(optimizer);
    if (!optimizer.isSolverSuitable(property)) return 1;
    if (property.requiresMarginalize) marginalize_landmarks(optimizer);
    // [/factory]
    // [stop]
    SparseOptimizerTerminateAction terminate;
    terminate.setGainThreshold(1e-6);
    optimizer.addPostIterationAction(&terminate);
    // [/stop]
    note(solve("lm_fix3_2, by name, until it stalls:", optimizer));
    std::printf("  %zu iterations\n", optimizer.batchStatistics().size());
    optimizer.removePostIterationAction(&terminate);
  }
  return largest - smallest < 1e-3 * largest ? 0 : 1;
}
