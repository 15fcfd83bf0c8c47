// SPDX-License-Identifier: BSD-3-Clause
// Edges whose vertices or dimension change while they are in a graph. Meant to run under AddressSanitizer.
#include "g2o/core/base_multi_edge.h"

#include <gtest/gtest.h>

#include <memory>

#include "g2o/core/base_vertex.h"
#include "g2o/core/small_graph.h"

namespace {

class Number : public g2o::BaseVertex<1, double> {
 public:
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* step) override { _estimate += step[0]; }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// An edge whose error has equal rows: each is the sum of all estimates, minus 1.
class Sum : public g2o::BaseMultiEdge<Eigen::Dynamic, double> {
 public:
  explicit Sum(int rows) {
    setDimension(rows);
    setInformation(g2o::MatrixX::Identity(rows, rows));
  }
  void computeError() override {
    double sum = -1;
    for (const auto* v : _vertices) sum += static_cast<const Number*>(v)->estimate();
    _error.setConstant(sum);
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// An edge with three vertices and two rows, which was optimized once before a test resizes it.
class ResizedEdge : public testing::Test {
 protected:
  void SetUp() override {
    optimizer.setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmLevenberg>(small_graph::make_solver()));
    for (int id = 0; id < 3; ++id) {
      auto* v = new Number;
      v->setToOrigin();
      v->setId(id);
      ASSERT_TRUE(optimizer.addVertex(v));
    }
    sum = new Sum(2);
    sum->resize(3);
    for (int id = 0; id < 3; ++id) sum->setVertex(static_cast<size_t>(id), optimizer.vertex(id));
    ASSERT_TRUE(optimizer.addEdge(sum));
    expect_a_fit();
  }
  void expect_a_fit() {
    static_cast<Number*>(optimizer.vertex(0))->setEstimate(5);
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_GT(optimizer.optimize(5), 0);
    optimizer.computeActiveErrors();
    EXPECT_LT(optimizer.activeChi2(), 1e-8);
  }
  g2o::SparseOptimizer optimizer;
  Sum* sum = nullptr;
};

TEST_F(ResizedEdge, StaysActiveIfItsSizeIsTheSame) {
  sum->resize(3);
  static_cast<Number*>(optimizer.vertex(0))->setEstimate(5);
  EXPECT_GT(optimizer.optimize(5), 0);
  optimizer.computeActiveErrors();
  EXPECT_LT(optimizer.activeChi2(), 1e-8);
}

TEST_F(ResizedEdge, CanBeOptimizedWithFewerVertices) {
  optimizer.vertex(2)->edges().erase(sum);
  sum->resize(2);
  expect_a_fit();
}

TEST_F(ResizedEdge, CanBeOptimizedWithMoreVertices) {
  auto* v = new Number;
  v->setToOrigin();
  v->setId(3);
  ASSERT_TRUE(optimizer.addVertex(v));
  sum->resize(4);
  ASSERT_TRUE(optimizer.setEdgeVertex(sum, 3, v));
  expect_a_fit();
}

TEST_F(ResizedEdge, IsNotOptimizedIfOneOfItsVerticesIsMissing) {
  sum->resize(4);
  for (int id = 0; id < 3; ++id) sum->setVertex(static_cast<size_t>(id), optimizer.vertex(id));
  EXPECT_EQ(optimizer.optimize(5), -1);
  EXPECT_FALSE(optimizer.initializeOptimization());
}

TEST_F(ResizedEdge, HasMemoryForItsJacobiansIfItsDimensionGrowsDuringARun) {
  struct Grow : g2o::HyperGraphAction {
    Sum* sum = nullptr;
    g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
      sum->setDimension(2 * sum->dimension());
      return this;
    }
  } grow;
  grow.sum = sum;
  optimizer.addPreIterationAction(&grow);
  expect_a_fit();
  EXPECT_GT(sum->dimension(), 4);
}

TEST_F(ResizedEdge, HasMemoryForItsJacobiansIfItsDimensionGrowsBeforeARun) {
  sum->setDimension(2000);
  sum->setInformation(g2o::MatrixX::Identity(2000, 2000));
  expect_a_fit();
}

}  // namespace
