// SPDX-License-Identifier: BSD-3-Clause
// A client that loads a pose graph from a file, optimizes it and saves it, with the current and the old API.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/linear_solver_csparse.h"
#include "g2o/types/slam3d/types_slam3d.h"

G2O_USE_TYPE_GROUP(slam3d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

namespace {

/// A ring of poses whose odometry overestimates the rotation slightly, and one loop closure.
class PoseGraph : public testing::Test {
 protected:
  static constexpr int kPoses = 24;

  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    path_ = testing::TempDir() + "g2o_pose_graph_" + name + "_in.g2o";
    result_ = testing::TempDir() + "g2o_pose_graph_" + name + "_out.g2o";
    const double turn = 2 * M_PI / kPoses;
    g2o::SparseOptimizer graph;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; i < kPoses; ++i) {
      auto* v = new g2o::VertexSE3;
      v->setId(i);
      v->setEstimate(pose);
      graph.addVertex(v);
      pose = pose * motion(turn + 0.01);
    }
    for (int i = 0; i < kPoses; ++i) {
      auto* e = new g2o::EdgeSE3;
      e->setVertex(0, graph.vertex(i));
      e->setVertex(1, graph.vertex((i + 1) % kPoses));
      e->setMeasurement(motion(i + 1 < kPoses ? turn + 0.01 : turn));
      e->setInformation(Eigen::Matrix<double, 6, 6>::Identity() * (i + 1 < kPoses ? 1 : 100));
      graph.addEdge(e);
    }
    graph.vertex(0)->setFixed(true);
    ASSERT_TRUE(graph.save(path_.c_str()));
  }
  void TearDown() override {
    std::remove(path_.c_str());
    std::remove(result_.c_str());
  }

  static Eigen::Isometry3d motion(double yaw) {
    Eigen::Isometry3d m = Eigen::Isometry3d::Identity();
    m.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    m.translation() = Eigen::Vector3d(1, 0, 0.1);
    return m;
  }

  static double chi2_of_file(const std::string& path) {
    g2o::SparseOptimizer graph;
    EXPECT_TRUE(graph.load(path));
    EXPECT_TRUE(graph.vertex(0)->fixed());
    EXPECT_TRUE(graph.initializeOptimization());
    graph.computeActiveErrors();
    return graph.activeChi2();
  }

  std::string path_, result_;
};

TEST_F(PoseGraph, IsOptimizedAndSavedWithTheCurrentApi) {
  auto linear = std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolver_6_3::PoseMatrixType>>();
  auto optimizer = std::make_unique<g2o::SparseOptimizer>();
  optimizer->setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmGaussNewton>(
      std::make_unique<g2o::BlockSolver_6_3>(std::move(linear))));
  std::ifstream in(path_);
  ASSERT_TRUE(optimizer->load(in));
  ASSERT_TRUE(optimizer->initializeOptimization());
  EXPECT_EQ(optimizer->optimize(10), 10);
  ASSERT_TRUE(optimizer->save(result_.c_str()));
  optimizer->computeActiveErrors();
  EXPECT_LT(optimizer->chi2(), 0.2 * chi2_of_file(path_));
  EXPECT_EQ(chi2_of_file(result_), optimizer->chi2()) << "the file must contain all digits of the estimates";
}

TEST_F(PoseGraph, HasTheSameFinalChi2WithTheOldApiAndWithAnAlgorithmOfTheFactory) {
  typedef g2o::BlockSolver<g2o::BlockSolverTraits<6, 3>> Block;
  Block::LinearSolverType* linearSolver = new g2o::LinearSolverCSparse<Block::PoseMatrixType>();
  Block* solver_ptr = new Block(linearSolver);
  g2o::OptimizationAlgorithmLevenberg* solver = new g2o::OptimizationAlgorithmLevenberg(solver_ptr);
  solver->setUserLambdaInit(1e-16);
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(solver);
  ASSERT_TRUE(optimizer.load(path_.c_str()));
  g2o::VertexSE3* first = dynamic_cast<g2o::VertexSE3*>(optimizer.vertices()[0]);
  ASSERT_NE(first, nullptr);
  first->setFixed(true);
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(30), 0);
  const double chi2 = optimizer.chi2();

  g2o::SparseOptimizer other;
  g2o::OptimizationAlgorithmProperty property;
  other.setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct("lm_fix6_3", property));
  ASSERT_TRUE(other.load(path_.c_str()));
  other.initializeOptimization();
  EXPECT_GT(other.optimize(30), 0);
  EXPECT_NEAR(other.chi2(), chi2, 1e-6 * chi2);
}

}  // namespace
