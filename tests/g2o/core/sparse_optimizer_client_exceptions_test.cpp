// SPDX-License-Identifier: BSD-3-Clause
// If client code throws an exception during a run, optimize() passes the exception to its caller. The step in
// which the exception was thrown does not change the estimates.
#include <gmock/gmock.h>

#include <stdexcept>
#include <utility>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/small_graph.h"

namespace {

using small_graph::add_square;
using small_graph::make_solver;

/// A prior at the origin whose n-th evaluation throws.
class FragileEdge : public g2o::BaseUnaryEdge<3, g2o::SE2, g2o::VertexSE2> {
 public:
  explicit FragileEdge(int evaluations) : left(evaluations) {}
  void computeError() override {
    if (--left == 0) throw std::runtime_error("fragile");
    _error = vertexXn<0>()->estimate().toVector();
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream&) const override { return true; }

  int left;
};

/// A pose whose push() throws.
class FragileVertex : public g2o::VertexSE2 {
 public:
  void push() override { throw std::runtime_error("fragile"); }
};

class ClientExceptions : public testing::Test {
 protected:
  FragileEdge* add_fragile(int evaluations) {
    auto* e = new FragileEdge(evaluations);
    e->setVertex(0, optimizer.vertex(2));
    e->setInformation(Eigen::Matrix3d::Identity());
    EXPECT_TRUE(optimizer.addEdge(e));
    return e;
  }
  /// The estimates of all poses, one in each column.
  Eigen::Matrix<double, 3, 4> poses() {
    Eigen::Matrix<double, 3, 4> result;
    for (int i = 0; i < 4; ++i)
      result.col(i) = static_cast<g2o::VertexSE2*>(optimizer.vertex(i))->estimate().toVector();
    return result;
  }
  void expect_empty_stacks() {
    for (const auto& [id, v] : optimizer.vertices())
      EXPECT_EQ(static_cast<g2o::OptimizableGraph::Vertex*>(v)->stackSize(), 0) << "vertex " << id;
  }
  g2o::SparseOptimizer optimizer;
};

// The edge is evaluated once for chi2, six times for its numeric Jacobian, and once for each step. Therefore,
// its eighth evaluation belongs to the first step.
TEST_F(ClientExceptions, AStepThatThrowsIsUndone) {
  for (const bool dogleg : {false, true}) {
    SCOPED_TRACE(dogleg ? "dogleg" : "levenberg");
    optimizer.clear();
    add_square(optimizer);
    FragileEdge* edge = add_fragile(8);
    if (dogleg) optimizer.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(make_solver()));
    if (!dogleg) optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
    ASSERT_TRUE(optimizer.initializeOptimization());
    const auto before = poses();
    EXPECT_THROW(optimizer.optimize(3), std::runtime_error);
    EXPECT_EQ(edge->left, 0);
    EXPECT_EQ(poses(), before);
    expect_empty_stacks();
    EXPECT_GT(optimizer.optimize(3), 0) << "the optimizer still works";
    EXPECT_NE(poses(), before);
  }
}

TEST_F(ClientExceptions, AnErrorFunctionThatThrowsDuringNumericDifferentiationDoesNotMoveItsVertex) {
  add_square(optimizer);
  FragileEdge* edge = add_fragile(4);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  const auto before = poses();
  EXPECT_THROW(optimizer.optimize(3), std::runtime_error);
  EXPECT_EQ(edge->left, 0);
  EXPECT_EQ(poses(), before);
  expect_empty_stacks();
}

TEST_F(ClientExceptions, AllStacksAreEmptyAfterAPushThatThrows) {
  add_square(optimizer);
  auto* v = new FragileVertex;
  v->setId(4);
  ASSERT_TRUE(optimizer.addVertex(v));
  small_graph::add_motion(optimizer, 3, 4, g2o::SE2(1, 0, 0));
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_THROW(optimizer.optimize(1), std::runtime_error);
  expect_empty_stacks();
}

/// An action that throws when it is called for the n-th time.
class FragileAction : public g2o::HyperGraphAction {
 public:
  explicit FragileAction(int calls) : left(calls) {}
  HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    if (--left == 0) throw std::runtime_error("fragile");
    return this;
  }
  int left;
};

TEST_F(ClientExceptions, TheOptimizerStaysUsableAfterAnActionThatThrows) {
  using Add = bool (g2o::SparseOptimizer::*)(g2o::HyperGraphAction*);
  const std::pair<Add, Add> kinds[] = {
      {&g2o::SparseOptimizer::addPreIterationAction, &g2o::SparseOptimizer::removePreIterationAction},
      {&g2o::SparseOptimizer::addPostIterationAction, &g2o::SparseOptimizer::removePostIterationAction},
      {&g2o::SparseOptimizer::addComputeErrorAction, &g2o::SparseOptimizer::removeComputeErrorAction}};
  for (const auto& [add, remove] : kinds) {
    for (const bool is_verbose : {false, true}) {
      optimizer.clear();
      add_square(optimizer);
      optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
      optimizer.setComputeBatchStatistics(is_verbose);
      ASSERT_TRUE(optimizer.initializeOptimization());
      FragileAction action(2);
      ASSERT_TRUE((optimizer.*add)(&action));
      EXPECT_THROW(optimizer.optimize(5), std::runtime_error);
      EXPECT_EQ(action.left, 0);
      ASSERT_TRUE((optimizer.*remove)(&action));
      expect_empty_stacks();
      EXPECT_GT(optimizer.optimize(5), 0);
    }
  }
}

}  // namespace
