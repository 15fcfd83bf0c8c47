// SPDX-License-Identifier: BSD-3-Clause
// A client that plans a path and derives its edges from its own base class templates. The edges remove
// themselves from their vertices in their destructors, compute errors outside of a run, and override
// resize(). The client registers its types with raw pointers, and sums up the cost of its path for each type
// of edge.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_multi_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
#include "g2o/solvers/csparse/linear_solver_csparse.h"

namespace {

struct Config {
  double spacing = 0.3;
  Eigen::Vector2d via{1, 0.5};
};

template <int D, typename E, typename VertexXi>
class BasePlannerUnaryEdge : public g2o::BaseUnaryEdge<D, E, VertexXi> {
 public:
  using typename g2o::BaseUnaryEdge<D, E, VertexXi>::ErrorVector;
  using g2o::BaseUnaryEdge<D, E, VertexXi>::computeError;
  BasePlannerUnaryEdge() { _vertices[0] = nullptr; }
  ~BasePlannerUnaryEdge() override {
    if (_vertices[0]) _vertices[0]->edges().erase(this);
  }
  ErrorVector& getError() {
    computeError();
    return _error;
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream& os) const override { return os.good(); }
  void setConfig(const Config& cfg) { cfg_ = &cfg; }

 protected:
  using g2o::BaseUnaryEdge<D, E, VertexXi>::_error;
  using g2o::BaseUnaryEdge<D, E, VertexXi>::_vertices;
  const Config* cfg_ = nullptr;

 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

template <int D, typename E, typename VertexXi, typename VertexXj>
class BasePlannerBinaryEdge : public g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj> {
 public:
  using typename g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::ErrorVector;
  using g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::computeError;
  BasePlannerBinaryEdge() { _vertices[0] = _vertices[1] = nullptr; }
  ~BasePlannerBinaryEdge() override {
    if (_vertices[0]) _vertices[0]->edges().erase(this);
    if (_vertices[1]) _vertices[1]->edges().erase(this);
  }
  ErrorVector& getError() {
    computeError();
    return _error;
  }
  bool read(std::istream& is) override {
    is >> _measurement;
    return true;
  }
  bool write(std::ostream& os) const override {
    os << information() << " Error: " << _error << ", Measurement: " << _measurement;
    return os.good();
  }
  void setConfig(const Config& cfg) { cfg_ = &cfg; }

 protected:
  using g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::_error;
  using g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::_vertices;
  using g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::_measurement;
  using g2o::BaseBinaryEdge<D, E, VertexXi, VertexXj>::information;
  const Config* cfg_ = nullptr;
};

template <int D, typename E>
class BasePlannerMultiEdge : public g2o::BaseMultiEdge<D, E> {
 public:
  using typename g2o::BaseMultiEdge<D, E>::ErrorVector;
  using g2o::BaseMultiEdge<D, E>::computeError;
  ~BasePlannerMultiEdge() override {
    for (std::size_t i = 0; i < _vertices.size(); ++i) {
      if (_vertices[i]) _vertices[i]->edges().erase(this);
    }
  }
  void resize(size_t size) override {
    g2o::BaseMultiEdge<D, E>::resize(size);
    for (std::size_t i = 0; i < _vertices.size(); ++i) _vertices[i] = nullptr;
  }
  ErrorVector& getError() {
    computeError();
    return _error;
  }
  bool read(std::istream& is) override {
    is >> _measurement;
    return true;
  }
  bool write(std::ostream& os) const override { return os.good(); }

 protected:
  using g2o::BaseMultiEdge<D, E>::_error;
  using g2o::BaseMultiEdge<D, E>::_vertices;
  using g2o::BaseMultiEdge<D, E>::_measurement;
};

class VertexPoint2D : public g2o::BaseVertex<2, Eigen::Vector2d> {
 public:
  explicit VertexPoint2D(bool fixed = false) {
    setToOriginImpl();
    setFixed(fixed);
  }
  Eigen::Vector2d& position() { return _estimate; }
  const Eigen::Vector2d& position() const { return _estimate; }
  void setToOriginImpl() override { _estimate.setZero(); }
  void oplusImpl(const double* update) override { _estimate += Eigen::Map<const Eigen::Vector2d>(update); }
  bool read(std::istream& is) override {
    is >> _estimate.x() >> _estimate.y();
    return true;
  }
  bool write(std::ostream& os) const override {
    os << _estimate.x() << " " << _estimate.y();
    return os.good();
  }
};

class EdgeVia : public BasePlannerUnaryEdge<1, const Eigen::Vector2d*, VertexPoint2D> {
 public:
  EdgeVia() { _measurement = nullptr; }
  void computeError() override {
    const auto* point = static_cast<const VertexPoint2D*>(_vertices[0]);
    _error[0] = (point->position() - *_measurement).norm();
  }
};

class EdgeSpacing : public BasePlannerBinaryEdge<1, double, VertexPoint2D, VertexPoint2D> {
 public:
  void computeError() override {
    const auto* a = static_cast<const VertexPoint2D*>(_vertices[0]);
    const auto* b = static_cast<const VertexPoint2D*>(_vertices[1]);
    _error[0] = (b->position() - a->position()).norm() - cfg_->spacing;
  }
};

class EdgeSmooth : public BasePlannerMultiEdge<2, double> {
 public:
  EdgeSmooth() { this->resize(3); }
  void computeError() override {
    const auto* a = static_cast<const VertexPoint2D*>(_vertices[0]);
    const auto* b = static_cast<const VertexPoint2D*>(_vertices[1]);
    const auto* c = static_cast<const VertexPoint2D*>(_vertices[2]);
    _error = a->position() - 2 * b->position() + c->position();
  }
};

using PlannerBlockSolver = g2o::BlockSolver<g2o::BlockSolverTraits<-1, -1>>;

/// A planner that uses the linear solver `Linear`.
template <class Linear>
class BandPlanner {
 public:
  BandPlanner() {
    registerTypes();
    std::unique_ptr<Linear> linear_solver(new Linear());
    linear_solver->setBlockOrdering(true);
    std::unique_ptr<PlannerBlockSolver> block_solver(new PlannerBlockSolver(std::move(linear_solver)));
    optimizer_->setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::move(block_solver)));
    for (int i = 0; i < 9; ++i) {
      points_.push_back(new VertexPoint2D(i == 0 || i == 8));
      points_.back()->position() = Eigen::Vector2d(0.25 * i, 0);
    }
  }
  ~BandPlanner() {
    clearGraph();
    for (VertexPoint2D* point : points_) delete point;
  }
  BandPlanner(const BandPlanner&) = delete;
  BandPlanner& operator=(const BandPlanner&) = delete;

  static void registerTypes() {
    g2o::Factory* factory = g2o::Factory::instance();
    if (factory->knowsTag("VERTEX_POINT2D")) return;
    factory->registerType("VERTEX_POINT2D", new g2o::HyperGraphElementCreator<VertexPoint2D>);
    factory->registerType("EDGE_VIA", new g2o::HyperGraphElementCreator<EdgeVia>);
    factory->registerType("EDGE_SPACING", new g2o::HyperGraphElementCreator<EdgeSpacing>);
    factory->registerType("EDGE_SMOOTH", new g2o::HyperGraphElementCreator<EdgeSmooth>);
  }

  bool plan() {
    buildGraph();
    const bool ok = optimizer_->initializeOptimization() && optimizer_->optimize(10) > 0;
    clearGraph();
    return ok;
  }

  /// The cost of the path for each type of edge. If there is no graph yet, builds it and clears it
  /// afterwards.
  std::vector<double> costs() {
    bool graph_exist_flag = !(optimizer_->edges().empty() && optimizer_->vertices().empty());
    if (!graph_exist_flag) {
      buildGraph();
      optimizer_->initializeOptimization();
    }
    optimizer_->computeInitialGuess();
    std::vector<double> sums(3, 0.);
    for (std::vector<g2o::OptimizableGraph::Edge*>::const_iterator it = optimizer_->activeEdges().begin();
         it != optimizer_->activeEdges().end(); it++) {
      if (EdgeVia* via = dynamic_cast<EdgeVia*>(*it)) {
        sums[0] += via->getError().squaredNorm();
      } else if (EdgeSpacing* spacing = dynamic_cast<EdgeSpacing*>(*it)) {
        sums[1] += spacing->getError().squaredNorm();
      } else if (EdgeSmooth* smooth = dynamic_cast<EdgeSmooth*>(*it)) {
        sums[2] += smooth->getError().squaredNorm();
      }
    }
    if (!graph_exist_flag) clearGraph();
    return sums;
  }

  void buildGraph() {
    for (size_t i = 0; i < points_.size(); ++i) {
      points_[i]->setId(static_cast<int>(i));
      ASSERT_TRUE(optimizer_->addVertex(points_[i]));
    }
    for (size_t i = 0; i + 1 < points_.size(); ++i) {
      EdgeSpacing* spacing = new EdgeSpacing;
      spacing->setVertex(0, points_[i]);
      spacing->setVertex(1, points_[i + 1]);
      spacing->setInformation(Eigen::Matrix<double, 1, 1>::Constant(2));
      spacing->setConfig(cfg_);
      ASSERT_TRUE(optimizer_->addEdge(spacing));
      if (i == 0) continue;
      EdgeSmooth* smooth = new EdgeSmooth;
      for (size_t k = 0; k < 3; ++k) smooth->setVertex(k, points_[i + k - 1]);
      smooth->setInformation(Eigen::Matrix2d::Identity());
      ASSERT_TRUE(optimizer_->addEdge(smooth));
    }
    EdgeVia* via = new EdgeVia;
    via->setVertex(0, points_[4]);
    via->setMeasurement(&cfg_.via);
    via->setInformation(Eigen::Matrix<double, 1, 1>::Constant(10));
    ASSERT_TRUE(optimizer_->addEdge(via));
  }

  /// The client owns the points. The edges remove themselves from the points in their destructors.
  void clearGraph() {
    optimizer_->vertices().clear();
    optimizer_->clear();
    for (const VertexPoint2D* point : points_) EXPECT_TRUE(point->edges().empty());
  }

  std::shared_ptr<g2o::SparseOptimizer> optimizer_ = std::make_shared<g2o::SparseOptimizer>();
  std::vector<VertexPoint2D*> points_;
  Config cfg_;
};

template <class Linear>
class PlannerBases : public testing::Test {};
using Solvers = testing::Types<g2o::LinearSolverCSparse<PlannerBlockSolver::PoseMatrixType>,
                               g2o::LinearSolverCholmod<PlannerBlockSolver::PoseMatrixType>>;
TYPED_TEST_SUITE(PlannerBases, Solvers, );  // clang++ requires the empty argument

TYPED_TEST(PlannerBases, ThePathPassesTheViaPoint) {
  BandPlanner<TypeParam> planner;
  const std::vector<double> before = planner.costs();
  EXPECT_NEAR(before[0], 0.25, 1e-12);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(planner.plan());
  const std::vector<double> after = planner.costs();
  EXPECT_LT(after[0], 0.02);
  EXPECT_LT(after[1], before[1]);
}

TYPED_TEST(PlannerBases, ComputingTheCostsDoesNotClearAGraphThatExistedBefore) {
  BandPlanner<TypeParam> planner;
  planner.buildGraph();
  planner.optimizer_->initializeOptimization();
  EXPECT_EQ(planner.costs().size(), 3u);
  EXPECT_EQ(planner.optimizer_->edges().size(), 16u);
  EXPECT_GT(planner.optimizer_->optimize(3), 0);
}

TYPED_TEST(PlannerBases, AnOptimizerDeletesThePointsAndEdgesThatItOwns) {
  g2o::SparseOptimizer optimizer;
  Config cfg;
  for (int i = 0; i < 2; ++i) {
    auto* point = new VertexPoint2D;
    point->setId(i);
    optimizer.addVertex(point);
  }
  auto* spacing = new EdgeSpacing;
  spacing->setVertex(0, optimizer.vertex(0));
  spacing->setVertex(1, optimizer.vertex(1));
  spacing->setConfig(cfg);
  EXPECT_TRUE(optimizer.addEdge(spacing));
}

}  // namespace
