// SPDX-License-Identifier: BSD-3-Clause
// A client that fits a curve with a custom vertex and a custom unary edge. It uses smart pointers as in
// current g2o, and raw pointers as in old g2o.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/solvers/pcg/linear_solver_pcg.h"

namespace {

/// The parameters of y = exp(a x² + b x + c).
class CurveVertex : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate << 0, 0, 0; }
  void oplusImpl(const double* update) override { _estimate += Eigen::Vector3d(update); }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

class CurveEdge : public g2o::BaseUnaryEdge<1, double, CurveVertex> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  explicit CurveEdge(double x) : x_(x) {}
  void computeError() override {
    const auto* v = static_cast<const CurveVertex*>(_vertices[0]);
    _error(0, 0) = _measurement - curve(v->estimate());
  }
  void linearizeOplus() override {
    const auto* v = static_cast<const CurveVertex*>(_vertices[0]);
    const double y = curve(v->estimate());
    _jacobianOplusXi[0] = -x_ * x_ * y;
    _jacobianOplusXi[1] = -x_ * y;
    _jacobianOplusXi[2] = -y;
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }

 protected:
  double curve(const Eigen::Vector3d& abc) const { return std::exp(abc[0] * x_ * x_ + abc[1] * x_ + abc[2]); }
  double x_;
};

/// The same edge without an analytic Jacobian.
class NumericCurveEdge : public CurveEdge {
 public:
  using CurveEdge::CurveEdge;
  void linearizeOplus() override { g2o::BaseUnaryEdge<1, double, CurveVertex>::linearizeOplus(); }
};

const Eigen::Vector3d kTruth(1, 2, 1);
using BlockSolverType = g2o::BlockSolver<g2o::BlockSolverTraits<3, 1>>;

template <class Edge>
CurveVertex* add_curve(g2o::SparseOptimizer& optimizer) {
  auto* v = new CurveVertex();
  v->setEstimate(Eigen::Vector3d(2, -1, 5));
  v->setId(0);
  optimizer.addVertex(v);
  for (int i = 0; i < 100; ++i) {
    const double x = i / 100.0;
    auto* edge = new Edge(x);
    edge->setId(i);
    edge->setVertex(0, v);
    edge->setMeasurement(std::exp(kTruth[0] * x * x + kTruth[1] * x + kTruth[2]));
    edge->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
    optimizer.addEdge(edge);
  }
  return v;
}

template <class Edge, class LinearSolver>
Eigen::Vector3d fitted_by_gauss_newton() {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      std::make_unique<BlockSolverType>(std::make_unique<LinearSolver>())));
  const CurveVertex* v = add_curve<Edge>(optimizer);
  EXPECT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(30), 30);
  return v->estimate();
}

void expect_truth(const Eigen::Vector3d& estimate, double tolerance = 1e-9) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(estimate[i], kTruth[i], tolerance);
}

TEST(CurveFit, GaussNewtonFindsTheCurveWithAnyLinearSolver) {
  expect_truth(fitted_by_gauss_newton<CurveEdge, g2o::LinearSolverDense<BlockSolverType::PoseMatrixType>>());
  expect_truth(fitted_by_gauss_newton<CurveEdge, g2o::LinearSolverEigen<BlockSolverType::PoseMatrixType>>());
  expect_truth(fitted_by_gauss_newton<CurveEdge, g2o::LinearSolverPCG<BlockSolverType::PoseMatrixType>>());
}

TEST(CurveFit, GaussNewtonFindsTheCurveWithNumericJacobians) {
  expect_truth(
      fitted_by_gauss_newton<NumericCurveEdge, g2o::LinearSolverDense<BlockSolverType::PoseMatrixType>>());
}

TEST(CurveFit, LevenbergMarquardtWithRawPointersFindsTheCurve) {
  using Solver = g2o::BlockSolver<g2o::BlockSolverTraits<3, 1>>;
  Solver::LinearSolverType* linearSolver = new g2o::LinearSolverDense<Solver::PoseMatrixType>();
  Solver* solver_ptr = new Solver(linearSolver);
  auto* solver = new g2o::OptimizationAlgorithmLevenberg(solver_ptr);
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(solver);
  optimizer.setVerbose(false);
  const CurveVertex* v = add_curve<CurveEdge>(optimizer);
  optimizer.initializeOptimization();
  const int iterations = optimizer.optimize(100);
  EXPECT_GT(iterations, 3);
  expect_truth(v->estimate(), 1e-7);
  EXPECT_LT(optimizer.activeChi2(), 1e-10);
}

TEST(CurveFit, DoglegFindsTheCurve) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(std::make_unique<g2o::BlockSolverX>(
      std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>>())));
  const CurveVertex* v = add_curve<CurveEdge>(optimizer);
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(100), 0);
  expect_truth(v->estimate(), 1e-7);
}

TEST(CurveFit, OptimizeReturnsMinusOneIfTheOptimizerIsNotInitialized) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      new BlockSolverType(new g2o::LinearSolverDense<BlockSolverType::PoseMatrixType>())));
  EXPECT_EQ(optimizer.optimize(10), -1);
  EXPECT_FALSE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(10), -1);
}

TEST(CurveFit, OptimizeReturnsZeroAndMovesNothingIfTheSystemIsSingular) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      new BlockSolverType(new g2o::LinearSolverDense<BlockSolverType::PoseMatrixType>())));
  auto* v = new CurveVertex();
  v->setEstimate(Eigen::Vector3d(2, -1, 5));
  v->setId(0);
  optimizer.addVertex(v);
  auto* edge = new CurveEdge(0.5);
  edge->setVertex(0, v);
  edge->setMeasurement(1);
  optimizer.addEdge(edge);
  optimizer.initializeOptimization();
  EXPECT_EQ(optimizer.optimize(10), 0);
  EXPECT_EQ(v->estimate(), Eigen::Vector3d(2, -1, 5));
}

}  // namespace
