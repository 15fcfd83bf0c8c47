// SPDX-License-Identifier: BSD-3-Clause
// Tests the 2-D SLAM program that a reader of the g2o document gets by copying the listings of the document.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <sstream>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/manual/types.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

// The types and the algorithms are in static libraries that are linked only because of these macros.
G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_OPTIMIZATION_LIBRARY(manual);

namespace {

using manual::EdgeSE2;
using manual::EdgeSE2PointXY;
using manual::SE2;
using manual::VertexPointXY;
using manual::VertexSE2;

/// A robot that drives twice around a square and observes the landmarks near it.
struct World {
  std::vector<SE2> poses;
  std::vector<Eigen::Vector2d> landmarks;
};

World make_world() {
  World world;
  SE2 pose;
  for (int i = 0; i < 80; ++i) {
    world.poses.push_back(pose);
    pose = pose * SE2(1, 0, i % 10 == 9 ? M_PI / 2 : 0);
  }
  for (int i = 0; i < 25; ++i) world.landmarks.emplace_back(-2 + 3 * (i % 5), -2 + 3 * (i / 5));
  return world;
}

constexpr int kFirstLandmark = 1000;
constexpr double kRange = 4;

/// Adds the poses and the landmarks of the world with noisy measurements. The initial estimates of the poses
/// come from odometry.
void add_graph(const World& world, double noise, g2o::SparseOptimizer& optimizer) {
  std::mt19937 random(7);
  std::normal_distribution<double> standard(0, 1);
  const auto normal = [&](std::mt19937& generator) { return noise * standard(generator); };
  SE2 estimate;
  for (size_t i = 0; i < world.poses.size(); ++i) {
    auto* v = new VertexSE2;
    v->setId(static_cast<int>(i));
    v->setFixed(i == 0);
    optimizer.addVertex(v);
    if (i > 0) {
      const SE2 z = world.poses[i - 1].inverse() * world.poses[i] *
                    SE2(normal(random), normal(random), normal(random) / 4);
      estimate = estimate * z;
      auto* e = new EdgeSE2;
      e->vertices()[0] = optimizer.vertex(static_cast<int>(i) - 1);
      e->vertices()[1] = v;
      e->setMeasurement(z);
      e->setInformation(Eigen::Matrix3d(Eigen::Vector3d(100, 100, 1600).asDiagonal()));
      ASSERT_TRUE(optimizer.addEdge(e));
    }
    v->setEstimate(estimate);
    for (size_t l = 0; l < world.landmarks.size(); ++l) {
      const Eigen::Vector2d seen = world.poses[i].inverse() * world.landmarks[l];
      if (seen.norm() > kRange) continue;
      const int id = kFirstLandmark + static_cast<int>(l);
      const Eigen::Vector2d z = seen + Eigen::Vector2d(normal(random), normal(random));
      if (optimizer.vertex(id) == nullptr) {
        auto* landmark = new VertexPointXY;
        landmark->setId(id);
        landmark->setEstimate(estimate * z);
        optimizer.addVertex(landmark);
      }
      auto* e = new EdgeSE2PointXY;
      e->setVertex(0, v);
      e->setVertex(1, optimizer.vertex(id));
      e->setMeasurement(z);
      e->setInformation(Eigen::Matrix2d::Identity() * 100);
      ASSERT_TRUE(optimizer.addEdge(e));
    }
  }
}

double largest_distance(const World& world, const g2o::SparseOptimizer& optimizer) {
  double largest = 0;
  for (size_t i = 0; i < world.poses.size(); ++i) {
    const auto* v = static_cast<const VertexSE2*>(optimizer.vertex(static_cast<int>(i)));
    const SE2 difference = world.poses[i].inverse() * v->estimate();
    largest = std::max(largest, std::hypot(difference[0], difference[1]));
  }
  return largest;
}

std::unique_ptr<g2o::BlockSolverX> make_solver() {
  return std::make_unique<g2o::BlockSolverX>(
      std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>>());
}

TEST(Listings, ASimulatedRobotFindsItsPathDespiteNoise) {
  const World world = make_world();
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  add_graph(world, 0.05, optimizer);
  const double before = largest_distance(world, optimizer);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(10), 10);
  EXPECT_GT(before, 0.5);
  EXPECT_LT(largest_distance(world, optimizer), 0.2);
}

TEST(Listings, ARobotWithoutNoiseFindsItsPathExactly) {
  const World world = make_world();
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
  add_graph(world, 0, optimizer);
  for (const auto& [id, v] : optimizer.vertices()) {
    const double step[] = {0.1, -0.1, 0.05};
    if (id > 0) static_cast<g2o::OptimizableGraph::Vertex*>(v)->oplus(step);
  }
  optimizer.initializeOptimization();
  EXPECT_GT(optimizer.optimize(20), 1);
  EXPECT_LT(largest_distance(world, optimizer), 1e-6);
}

TEST(Listings, EliminatingLandmarksDoesNotChangeTheResult) {
  const World world = make_world();
  double chi2[2];
  for (const bool marginalize : {false, true}) {
    g2o::SparseOptimizer optimizer;
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(std::make_unique<g2o::BlockSolver_3_2>(
        std::make_unique<g2o::LinearSolverEigen<g2o::BlockSolver_3_2::PoseMatrixType>>())));
    add_graph(world, 0.05, optimizer);
    for (size_t l = 0; l < world.landmarks.size(); ++l)
      optimizer.vertex(kFirstLandmark + static_cast<int>(l))->setMarginalized(marginalize);
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_EQ(optimizer.optimize(5), 5);
    optimizer.computeActiveErrors();
    chi2[marginalize] = optimizer.activeChi2();
  }
  EXPECT_NEAR(chi2[0], chi2[1], 1e-9 * chi2[0]);
}

TEST(Listings, RegisteredTypesAreConstructedByTheirTags) {
  g2o::Factory* factory = g2o::Factory::instance();
  const auto make = [&](const char* tag) {
    return std::unique_ptr<g2o::HyperGraph::HyperGraphElement>(factory->construct(tag));
  };
  EXPECT_NE(dynamic_cast<VertexSE2*>(make("VERTEX_SE2").get()), nullptr);
  EXPECT_NE(dynamic_cast<VertexPointXY*>(make("VERTEX_XY").get()), nullptr);
  EXPECT_NE(dynamic_cast<EdgeSE2*>(make("EDGE_SE2").get()), nullptr);
  EXPECT_NE(dynamic_cast<EdgeSE2PointXY*>(make("EDGE_SE2_XY").get()), nullptr);
  EXPECT_EQ(make("EDGE_SE3:QUAT"), nullptr);
  EXPECT_EQ(factory->tag(make("VERTEX_XY").get()), "VERTEX_XY");
}

TEST(Listings, RegisteredAlgorithmsAreConstructedByTheirNames) {
  const World world = make_world();
  for (const char* name : {"gn_manual", "lm_manual", "gn_manual3_2"}) {
    g2o::SparseOptimizer optimizer;
    g2o::OptimizationAlgorithmProperty property;
    optimizer.setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct(name, property));
    ASSERT_NE(optimizer.algorithm(), nullptr) << name;
    EXPECT_EQ(property.name, name);
    add_graph(world, 0.05, optimizer);
    EXPECT_TRUE(optimizer.isSolverSuitable(property)) << name;
    for (size_t l = 0; l < world.landmarks.size(); ++l)
      optimizer.vertex(kFirstLandmark + static_cast<int>(l))->setMarginalized(property.requiresMarginalize);
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_GT(optimizer.optimize(10), 0);
    EXPECT_LT(largest_distance(world, optimizer), 0.2) << name;
  }
  g2o::OptimizationAlgorithmProperty property;
  EXPECT_EQ(g2o::OptimizationAlgorithmFactory::instance()->construct("no_such", property), nullptr);
}

TEST(Listings, TheGraphIsTheSameAfterSavingAndLoading) {
  const World world = make_world();
  g2o::SparseOptimizer optimizer, loaded;
  add_graph(world, 0.05, optimizer);
  std::stringstream first, second;
  ASSERT_TRUE(optimizer.save(first));
  ASSERT_TRUE(loaded.load(first));
  EXPECT_EQ(loaded.vertices().size(), optimizer.vertices().size());
  EXPECT_EQ(loaded.edges().size(), optimizer.edges().size());
  EXPECT_TRUE(loaded.vertex(0)->fixed());
  ASSERT_TRUE(loaded.save(second));
  EXPECT_EQ(first.str(), second.str());
}

}  // namespace
