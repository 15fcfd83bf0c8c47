// SPDX-License-Identifier: BSD-3-Clause
// A client that runs bundle adjustment as in visual SLAM: custom vertex and edge types, raw pointers, two
// rounds of optimization with the removal of outliers in between, a stop flag, and marginalized points.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/linear_solver_eigen.h"
#include "g2o/solvers/structure_only/structure_only_solver.h"

namespace {

/// The pose T_camera_world. A step is multiplied from the left.
class VertexPose : public g2o::BaseVertex<6, Eigen::Isometry3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate = Eigen::Isometry3d::Identity(); }
  void oplusImpl(const double* update) override {
    const Eigen::Vector3d omega(update[0], update[1], update[2]);
    Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
    if (omega.norm() > 0)
      step.linear() = Eigen::AngleAxisd(omega.norm(), omega.normalized()).toRotationMatrix();
    step.translation() = Eigen::Vector3d(update[3], update[4], update[5]);
    setEstimate(step * estimate());
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

class VertexPoint : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate.fill(0.); }
  void oplusImpl(const double* update) override {
    const Eigen::Map<const Eigen::Vector3d> v(update);
    _estimate += v;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

class EdgeProject : public g2o::BaseBinaryEdge<2, Eigen::Vector2d, VertexPoint, VertexPose> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void computeError() override {
    const auto* pose = static_cast<const VertexPose*>(_vertices[1]);
    const auto* point = static_cast<const VertexPoint*>(_vertices[0]);
    _error = _measurement - project(pose->estimate() * point->estimate());
  }
  bool isDepthPositive() {
    const auto* pose = static_cast<const VertexPose*>(_vertices[1]);
    const auto* point = static_cast<const VertexPoint*>(_vertices[0]);
    return (pose->estimate() * point->estimate())(2) > 0;
  }
  void linearizeOplus() override {
    const auto* pose = static_cast<VertexPose*>(_vertices[1]);
    const auto* point = static_cast<VertexPoint*>(_vertices[0]);
    const Eigen::Vector3d p = pose->estimate() * point->estimate();
    const double x = p[0], y = p[1], z = p[2], z2 = z * z;
    Eigen::Matrix<double, 2, 3> projection;
    projection << fx / z, 0, -x / z2 * fx, 0, fy / z, -y / z2 * fy;
    _jacobianOplusXi = -projection * pose->estimate().linear();
    Eigen::Matrix<double, 3, 6> motion;
    motion << 0, z, -y, 1, 0, 0, -z, 0, x, 0, 1, 0, y, -x, 0, 0, 0, 1;
    _jacobianOplusXj = -projection * motion;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  Eigen::Vector2d project(const Eigen::Vector3d& p) const {
    return Eigen::Vector2d(fx * p[0] / p[2] + cx, fy * p[1] / p[2] + cy);
  }
  double fx = 500, fy = 500, cx = 320, cy = 240;
};

struct Scene {
  std::vector<Eigen::Isometry3d> poses;
  std::vector<Eigen::Vector3d> points;
};

Scene make_scene() {
  Scene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 8; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(0.05 * i, Eigen::Vector3d::UnitY()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(-0.3 * i, 0.02 * i, 0);
    scene.poses.push_back(pose);
  }
  for (int j = 0; j < 120; ++j)
    scene.points.emplace_back(3 * uniform(random), 2 * uniform(random), 6 + 2 * uniform(random));
  return scene;
}

/// The 95 % quantile of the chi2 distribution with two degrees of freedom.
constexpr double kChi2Of95Percent = 5.991;

class BundleAdjustment : public testing::Test {
 protected:
  void SetUp() override {
    g2o::BlockSolver_6_3::LinearSolverType* linearSolver;
    linearSolver = new g2o::LinearSolverEigen<g2o::BlockSolver_6_3::PoseMatrixType>();
    g2o::BlockSolver_6_3* solver_ptr = new g2o::BlockSolver_6_3(linearSolver);
    g2o::OptimizationAlgorithmLevenberg* solver = new g2o::OptimizationAlgorithmLevenberg(solver_ptr);
    optimizer.setAlgorithm(solver);
    optimizer.setForceStopFlag(&stop);
  }

  /// Adds the scene with noisy pixel measurements. Every 20th measurement is an outlier.
  void add(const Scene& scene, bool marginalize) {
    std::mt19937 random(5);
    std::normal_distribution<double> pixel(0, 0.5), meter(0, 0.05);
    for (size_t i = 0; i < scene.poses.size(); ++i) {
      auto* v = new VertexPose();
      Eigen::Isometry3d estimate = scene.poses[i];
      if (i > 1) estimate.translation() += Eigen::Vector3d(meter(random), meter(random), meter(random));
      v->setEstimate(estimate);
      v->setId(static_cast<int>(i));
      v->setFixed(i < 2);
      optimizer.addVertex(v);
    }
    const float thHuber = std::sqrt(5.991f);
    int count = 0;
    for (size_t j = 0; j < scene.points.size(); ++j) {
      auto* point = new VertexPoint();
      point->setEstimate(scene.points[j] + Eigen::Vector3d(meter(random), meter(random), meter(random)));
      const int id = static_cast<int>(scene.poses.size() + j);
      point->setId(id);
      point->setMarginalized(marginalize);
      optimizer.addVertex(point);
      for (size_t i = 0; i < scene.poses.size(); ++i) {
        auto* e = new EdgeProject();
        e->setVertex(0, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(id)));
        e->setVertex(1, dynamic_cast<g2o::OptimizableGraph::Vertex*>(optimizer.vertex(static_cast<int>(i))));
        Eigen::Vector2d z = e->project(scene.poses[i] * scene.points[j]);
        z += Eigen::Vector2d(pixel(random), pixel(random));
        if (++count % 20 == 0) z += Eigen::Vector2d(60, -40);
        e->setMeasurement(z);
        e->setInformation(Eigen::Matrix2d::Identity() * 4);
        auto* rk = new g2o::RobustKernelHuber;
        e->setRobustKernel(rk);
        rk->setDelta(thHuber);
        optimizer.addEdge(e);
        edges.push_back(e);
      }
    }
  }

  int take_out_outliers() {
    int outliers = 0;
    for (EdgeProject* e : edges) {
      if (e->chi2() > kChi2Of95Percent * 2 || !e->isDepthPositive()) {
        e->setLevel(1);
        ++outliers;
      }
      e->setRobustKernel(0);
    }
    return outliers;
  }

  double worst_position(const Scene& scene) {
    double worst = 0;
    for (size_t i = 0; i < scene.poses.size(); ++i) {
      const auto* v = static_cast<VertexPose*>(optimizer.vertex(static_cast<int>(i)));
      worst = std::max(
          worst, (v->estimate().inverse().translation() - scene.poses[i].inverse().translation()).norm());
    }
    return worst;
  }

  bool stop = false;
  g2o::SparseOptimizer optimizer;
  std::vector<EdgeProject*> edges;
};

TEST_F(BundleAdjustment, TwoRoundsFindTheCamerasDespiteOutliers) {
  const Scene scene = make_scene();
  add(scene, true);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(5), 0);
  const int outliers = take_out_outliers();
  EXPECT_GE(outliers, static_cast<int>(edges.size()) / 20);
  EXPECT_LT(outliers, static_cast<int>(edges.size()) / 10);
  ASSERT_TRUE(optimizer.initializeOptimization(0));
  EXPECT_EQ(optimizer.activeEdges().size(), edges.size() - static_cast<size_t>(outliers));
  EXPECT_GT(optimizer.optimize(10), 0);
  EXPECT_LT(worst_position(scene), 0.01);
}

TEST_F(BundleAdjustment, TwoRoundsFindTheCamerasWithoutMarginalization) {
  const Scene scene = make_scene();
  add(scene, false);
  optimizer.initializeOptimization();
  optimizer.optimize(5);
  take_out_outliers();
  optimizer.initializeOptimization(0);
  optimizer.optimize(10);
  EXPECT_LT(worst_position(scene), 0.01);
}

TEST_F(BundleAdjustment, TheStructureOnlySolverMovesPointsButNotCameras) {
  const Scene scene = make_scene();
  add(scene, true);
  const Eigen::Isometry3d camera = static_cast<VertexPose*>(optimizer.vertex(4))->estimate();
  optimizer.initializeOptimization();
  optimizer.computeActiveErrors();
  const double before = optimizer.activeRobustChi2();
  g2o::StructureOnlySolver<3> solver;
  g2o::OptimizableGraph::VertexContainer points;
  for (auto* v : optimizer.activeVertices())
    if (v->dimension() == 3) points.push_back(v);
  solver.calc(points, 10);
  optimizer.computeActiveErrors();
  EXPECT_LT(optimizer.activeRobustChi2(), 0.9 * before);
  EXPECT_EQ(static_cast<VertexPose*>(optimizer.vertex(4))->estimate().matrix(), camera.matrix());
  EXPECT_FALSE(optimizer.vertex(4)->fixed());
  optimizer.setAlgorithm(std::make_unique<g2o::StructureOnlySolver<3>>());
  EXPECT_EQ(optimizer.optimize(3), 3);
}

TEST_F(BundleAdjustment, StopsIfTheClientSetsTheStopFlag) {
  add(make_scene(), true);
  optimizer.initializeOptimization();
  stop = true;
  EXPECT_EQ(optimizer.optimize(5), 0);
}

TEST_F(BundleAdjustment, TheCovarianceOfAPoseIsTheSameIfPointsAreMarginalized) {
  Eigen::MatrixXd covariance[2];
  for (const bool marginalize : {false, true}) {
    optimizer.clear();
    edges.clear();
    add(make_scene(), marginalize);
    optimizer.initializeOptimization();
    optimizer.optimize(10);
    g2o::SparseBlockMatrixXd spinv;
    ASSERT_TRUE(optimizer.computeMarginals(spinv, optimizer.vertex(5)));
    const int h = optimizer.vertex(5)->hessianIndex();
    covariance[marginalize] = *spinv.block(h, h);
  }
  EXPECT_LT((covariance[0] - covariance[1]).norm(), 1e-6 * covariance[0].norm());
}

}  // namespace
