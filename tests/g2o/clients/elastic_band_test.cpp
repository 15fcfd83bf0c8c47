// SPDX-License-Identifier: BSD-3-Clause
// A client that plans paths with a timed elastic band: multi-edges over poses and time differences, one
// optimizer that is cleared and rebuilt repeatedly, and vertices that the client owns.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_multi_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/stuff/misc.h"

namespace {

class VertexPose : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPose(double x, double y, double theta, bool fixed = false) {
    _estimate << x, y, theta;
    setFixed(fixed);
  }
  Eigen::Vector2d position() const { return _estimate.head<2>(); }
  double theta() const { return _estimate[2]; }
  void setToOriginImpl() override { _estimate.setZero(); }
  void oplusImpl(const double* update) override {
    _estimate.head<2>() += Eigen::Vector2d(update[0], update[1]);
    _estimate[2] = g2o::normalize_theta(_estimate[2] + update[2]);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

class VertexTimeDiff : public g2o::BaseVertex<1, double> {
 public:
  explicit VertexTimeDiff(double dt) { _estimate = dt; }
  double& dt() { return _estimate; }
  const double& dt() const { return _estimate; }
  void setToOriginImpl() override { _estimate = 0.1; }
  void oplusImpl(const double* update) override { _estimate += *update; }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

/// The amount by which the absolute value exceeds the bound.
double beyond(double value, double bound) {
  return std::max(0.0, std::abs(value) - bound);
}

/// Bounds the velocity, which is computed from two poses and a time difference.
class EdgeVelocity : public g2o::BaseMultiEdge<2, double> {
 public:
  EdgeVelocity() { this->resize(3); }
  void computeError() override {
    const auto* a = static_cast<const VertexPose*>(_vertices[0]);
    const auto* b = static_cast<const VertexPose*>(_vertices[1]);
    const auto* dt = static_cast<const VertexTimeDiff*>(_vertices[2]);
    _error[0] = beyond((b->position() - a->position()).norm() / dt->estimate(), 0.4);
    _error[1] = beyond(g2o::normalize_theta(b->theta() - a->theta()) / dt->estimate(), 0.6);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

/// Bounds the acceleration, which is computed from three poses and two time differences.
class EdgeAcceleration : public g2o::BaseMultiEdge<1, double> {
 public:
  EdgeAcceleration() { this->resize(5); }
  void computeError() override {
    const auto* a = static_cast<const VertexPose*>(_vertices[0]);
    const auto* b = static_cast<const VertexPose*>(_vertices[1]);
    const auto* c = static_cast<const VertexPose*>(_vertices[2]);
    const auto* dt1 = static_cast<const VertexTimeDiff*>(_vertices[3]);
    const auto* dt2 = static_cast<const VertexTimeDiff*>(_vertices[4]);
    const double v1 = (b->position() - a->position()).norm() / dt1->dt();
    const double v2 = (c->position() - b->position()).norm() / dt2->dt();
    _error[0] = beyond(2 * (v2 - v1) / (dt1->dt() + dt2->dt()), 0.5);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

/// The constraint that a wheeled robot moves along circular arcs.
class EdgeKinematics : public g2o::BaseBinaryEdge<1, double, VertexPose, VertexPose> {
 public:
  void computeError() override {
    const auto* a = static_cast<const VertexPose*>(_vertices[0]);
    const auto* b = static_cast<const VertexPose*>(_vertices[1]);
    const Eigen::Vector2d d = b->position() - a->position();
    _error[0] = (std::cos(a->theta()) + std::cos(b->theta())) * d[1] -
                (std::sin(a->theta()) + std::sin(b->theta())) * d[0];
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

class EdgeTimeOptimal : public g2o::BaseUnaryEdge<1, double, VertexTimeDiff> {
 public:
  EdgeTimeOptimal() { setMeasurement(0.); }
  void computeError() override { _error[0] = static_cast<const VertexTimeDiff*>(_vertices[0])->dt(); }
  void linearizeOplus() override { _jacobianOplusXi(0, 0) = 1; }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

class EdgeObstacle : public g2o::BaseUnaryEdge<1, const Eigen::Vector2d*, VertexPose> {
 public:
  EdgeObstacle() { _measurement = nullptr; }
  void computeError() override {
    const double distance = (static_cast<const VertexPose*>(_vertices[0])->position() - *_measurement).norm();
    _error[0] = std::max(0.0, 0.5 - distance);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }
};

class Planner {
 public:
  using Blocks = g2o::BlockSolver<g2o::BlockSolverTraits<-1, -1>>;
  using Linear = g2o::LinearSolverEigen<Blocks::PoseMatrixType>;

  Planner() {
    std::unique_ptr<Linear> linear_solver(new Linear());
    linear_solver->setBlockOrdering(true);
    std::unique_ptr<Blocks> block_solver(new Blocks(std::move(linear_solver)));
    optimizer_ = std::make_shared<g2o::SparseOptimizer>();
    optimizer_->setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::move(block_solver)));
    optimizer_->initMultiThreading();
    for (int i = 0; i <= 20; ++i) {
      const bool is_end = i == 0 || i == 20;
      poses_.push_back(std::make_unique<VertexPose>(0.2 * i, is_end ? 0 : 0.01, 0, is_end));
      if (i < 20) times_.push_back(std::make_unique<VertexTimeDiff>(0.3));
    }
  }
  ~Planner() { clear(); }

  /// One planning cycle: builds, optimizes and clears the graph five times with increasing weights.
  bool plan() {
    double weight = 1;
    for (int outer = 0; outer < 5; ++outer, weight *= 2) {
      build(weight);
      const bool ok = optimizer_->initializeOptimization() && optimizer_->optimize(5) > 0;
      optimizer_->computeActiveErrors();
      chi2_ = optimizer_->activeChi2();
      clear();
      if (!ok) return false;
    }
    return true;
  }

  /// Removes the first pose of the band, because the robot has moved on to the second one.
  void advance() {
    poses_.erase(poses_.begin());
    times_.erase(times_.begin());
    poses_.front()->setFixed(true);
  }
  size_t poses() const { return poses_.size(); }

  double nearest() const {
    double distance = 1e9;
    for (const auto& pose : poses_) distance = std::min(distance, (pose->position() - obstacle_).norm());
    return distance;
  }
  double duration() const {
    double sum = 0;
    for (const auto& time : times_) sum += time->dt();
    return sum;
  }
  double chi2() const { return chi2_; }

 private:
  template <class Edge>
  void add(Edge* edge, const std::vector<g2o::OptimizableGraph::Vertex*>& vertices, double weight) {
    for (size_t i = 0; i < vertices.size(); ++i) edge->setVertex(i, vertices[i]);
    edge->setInformation(Edge::InformationType::Identity() * weight);
    ASSERT_TRUE(optimizer_->addEdge(edge));
  }

  void build(double weight) {
    int id = 0;
    for (size_t i = 0; i < poses_.size(); ++i) {
      poses_[i]->setId(id++);
      optimizer_->addVertex(poses_[i].get());
      if (i >= times_.size()) continue;
      times_[i]->setId(id++);
      optimizer_->addVertex(times_[i].get());
    }
    for (size_t i = 0; i < times_.size(); ++i) {
      VertexPose *a = poses_[i].get(), *b = poses_[i + 1].get();
      add(new EdgeVelocity, {a, b, times_[i].get()}, 2);
      add(new EdgeKinematics, {a, b}, 1000);
      add(new EdgeTimeOptimal, {times_[i].get()}, 1);
      if (i > 0) {
        auto* obstacle = new EdgeObstacle;
        obstacle->setMeasurement(&obstacle_);
        add(obstacle, {a}, 50 * weight);
      }
      if (i + 1 < times_.size())
        add(new EdgeAcceleration, {a, b, poses_[i + 2].get(), times_[i].get(), times_[i + 1].get()}, 1);
    }
  }

  /// Removes the vertices from the optimizer before clear(), because the client owns them. clear() then
  /// deletes only the edges.
  void clear() {
    for (auto& entry : optimizer_->vertices()) entry.second->edges().clear();
    optimizer_->vertices().clear();
    optimizer_->clear();
  }

  std::shared_ptr<g2o::SparseOptimizer> optimizer_;
  std::vector<std::unique_ptr<VertexPose>> poses_;
  std::vector<std::unique_ptr<VertexTimeDiff>> times_;
  Eigen::Vector2d obstacle_{2, -0.1};
  double chi2_ = 0;
};

TEST(ElasticBand, AvoidsTheObstacleAtAReasonableSpeed) {
  Planner planner;
  EXPECT_LT(planner.nearest(), 0.2);
  for (int cycle = 0; cycle < 10; ++cycle) ASSERT_TRUE(planner.plan());
  EXPECT_GT(planner.nearest(), 0.4);
  EXPECT_GT(planner.duration(), 4 / 0.6);
  EXPECT_LT(planner.duration(), 4 / 0.2);
}

TEST(ElasticBand, AMovingRobotPlansRepeatedlyWithOneOptimizer) {
  Planner planner;
  auto next = std::chrono::steady_clock::now();
  while (planner.poses() > 4) {
    ASSERT_TRUE(planner.plan());
    const double before = planner.duration();
    planner.advance();
    EXPECT_LT(planner.duration(), before);
    next += std::chrono::milliseconds(50);  // plans at 20 Hz, if the machine is fast enough
    std::this_thread::sleep_until(next);
  }
  EXPECT_LT(planner.duration(), 3 * 0.2 / 0.2);
}

TEST(ElasticBand, ThePlanConvergesOverSeveralCycles) {
  Planner planner;
  for (int cycle = 0; cycle < 10; ++cycle) ASSERT_TRUE(planner.plan());
  const double before = planner.chi2();
  for (int cycle = 0; cycle < 10; ++cycle) ASSERT_TRUE(planner.plan());
  EXPECT_LT(planner.chi2(), 1.05 * before);
}

}  // namespace
