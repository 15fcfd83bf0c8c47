// SPDX-License-Identifier: BSD-3-Clause
// A client that fits a circle. It is written twice: for the current API of g2o and for its API before 2017.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/csparse/linear_solver_csparse.h"
#include "g2o/solvers/linear_solver_cholmod.h"

namespace {

const Eigen::Vector3d kTruth(4, -2, 2.5);  // center and radius

std::vector<Eigen::Vector2d> points_on_circle() {
  std::mt19937 generator(42);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.05 * i, r = kTruth[2] + noise(generator);
    points.emplace_back(kTruth[0] + r * std::cos(angle), kTruth[1] + r * std::sin(angle));
  }
  return points;
}

namespace today {

class VertexCircle : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  void setToOriginImpl() override {}
  void oplusImpl(const double* update) override {
    const Eigen::Vector3d::ConstMapType v(update);
    _estimate += v;
  }
};

class EdgePointOnCircle : public g2o::BaseUnaryEdge<1, Eigen::Vector2d, VertexCircle> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  void computeError() override {
    const VertexCircle* circle = vertexXn<0>();
    _error[0] = (_measurement - circle->estimate().head<2>()).norm() - circle->estimate()[2];
  }
};

Eigen::Vector3d fit() {
  using MyBlockSolver = g2o::BlockSolver<g2o::BlockSolverTraits<Eigen::Dynamic, Eigen::Dynamic>>;
  using MyLinearSolver = g2o::LinearSolverCSparse<MyBlockSolver::PoseMatrixType>;
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      std::make_unique<MyBlockSolver>(std::make_unique<MyLinearSolver>())));
  auto* circle = new VertexCircle();
  circle->setId(0);
  circle->setEstimate(Eigen::Vector3d(3, 3, 3));
  optimizer.addVertex(circle);
  for (const Eigen::Vector2d& point : points_on_circle()) {
    auto* e = new EdgePointOnCircle;
    e->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
    e->setVertex(0, circle);
    e->setMeasurement(point);
    optimizer.addEdge(e);
  }
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(20), 0);
  return circle->estimate();
}

}  // namespace today

namespace before_2017 {

class VertexCircle : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexCircle() {}
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  virtual void setToOriginImpl() {}
  virtual void oplusImpl(double* update) {
    Eigen::Vector3d::ConstMapType v(update);
    _estimate += v;
  }
};

class EdgePointOnCircle : public g2o::BaseUnaryEdge<1, Eigen::Vector2d, VertexCircle> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  virtual bool read(std::istream&) { return false; }
  virtual bool write(std::ostream&) const { return false; }
  void computeError() {
    const VertexCircle* circle = static_cast<const VertexCircle*>(vertex(0));
    const Eigen::Vector2d& center = circle->estimate().head<2>();
    _error(0) = (_measurement - center).norm() - circle->estimate()(2);
  }
  void linearizeOplus() {
    const VertexCircle* circle = static_cast<const VertexCircle*>(_vertices[0]);
    const Eigen::Vector2d d = circle->estimate().head<2>() - _measurement;
    _jacobianOplusXi.block<1, 2>(0, 0) = d.transpose() / d.norm();
    _jacobianOplusXi(0, 2) = -1;
  }
};

Eigen::Vector3d fit() {
  typedef g2o::BlockSolver<g2o::BlockSolverTraits<Eigen::Dynamic, Eigen::Dynamic>> MyBlockSolver;
  typedef g2o::LinearSolverCholmod<MyBlockSolver::PoseMatrixType> MyLinearSolver;
  g2o::SparseOptimizer optimizer;
  MyLinearSolver* linearSolver = new MyLinearSolver();
  linearSolver->setBlockOrdering(false);
  MyBlockSolver* blockSolver = new MyBlockSolver(linearSolver);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(blockSolver));
  VertexCircle* circle = new VertexCircle();
  circle->setId(0);
  circle->setEstimate(Eigen::Vector3d(3, 3, 3));
  optimizer.addVertex(circle);
  for (const Eigen::Vector2d& point : points_on_circle()) {
    EdgePointOnCircle* e = new EdgePointOnCircle;
    e->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
    e->vertices()[0] = circle;
    e->setMeasurement(point);
    e->setRobustKernel(0);
    optimizer.addEdge(e);
  }
  optimizer.initializeOptimization();
  optimizer.setVerbose(false);
  EXPECT_GT(optimizer.optimize(20), 0);
  return circle->estimate();
}

}  // namespace before_2017

TEST(CircleFit, FindsTheCircleWithTheCurrentApi) {
  EXPECT_LT((today::fit() - kTruth).norm(), 0.01);
}

TEST(CircleFit, FindsTheSameCircleWithTheOldApi) {
  EXPECT_LT((before_2017::fit() - today::fit()).norm(), 1e-7);
}

}  // namespace
