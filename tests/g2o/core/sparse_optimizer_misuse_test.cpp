// SPDX-License-Identifier: BSD-3-Clause
// Wrong use of the API is refused or reported with a message. Meant to run under AddressSanitizer.
#include <gmock/gmock.h>

#include <initializer_list>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"
#include "sanitized.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

using small_graph::add_pose;
using small_graph::add_square;
using small_graph::make_solver;

/// A fixture that collects the messages of the library.
class Misuse : public testing::Test {
 protected:
  void SetUp() override {
    g2o::logging::setSink([this](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  }
  void TearDown() override { g2o::logging::setSink({}); }
  void expect_message(const std::string& part) {
    EXPECT_THAT(messages, testing::Contains(testing::HasSubstr(part)));
    messages.clear();
  }
  std::vector<std::string> messages;
  g2o::SparseOptimizer optimizer;
};

TEST_F(Misuse, AVertexWhoseIdIsTakenIsRefusedAndBelongsToTheCaller) {
  add_pose(optimizer, 1, 0, 0, 0);
  auto second = std::make_unique<g2o::VertexSE2>();
  second->setId(1);
  EXPECT_FALSE(optimizer.addVertex(second.get()));
  expect_message("the id 1 is taken");
}

TEST_F(Misuse, AVertexOfAnotherGraphIsRefused) {
  g2o::SparseOptimizer other;
  auto* v = add_pose(other, 7, 0, 0, 0);
  EXPECT_FALSE(optimizer.addVertex(v));
  expect_message("already in another graph");
}

TEST_F(Misuse, AVertexIsNotAddedAgainUnderAnotherId) {
  auto* v = add_pose(optimizer, 7, 0, 0, 0);
  v->setId(8);
  EXPECT_FALSE(optimizer.addVertex(v));
  expect_message("vertex 8 is already in the graph, with id 7");
  v->setId(7);
}

TEST_F(Misuse, AVertexWithoutAnIdIsReported) {
  EXPECT_TRUE(optimizer.addVertex(new g2o::VertexSE2));
  expect_message("a vertex has id -2");
}

TEST_F(Misuse, AnEdgeWithMissingOrEqualVerticesIsRefusedAndBelongsToTheCaller) {
  add_pose(optimizer, 0, 0, 0, 0);
  auto e = std::make_unique<g2o::EdgeSE2>();
  EXPECT_FALSE(optimizer.addEdge(e.get()));
  expect_message("expected a vertex at every position");
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(0));
  EXPECT_FALSE(optimizer.addEdge(e.get()));
  expect_message("distinct");
}

TEST_F(Misuse, AnEdgeWithAVertexOfTheWrongTypeIsRefused) {
  add_pose(optimizer, 0, 0, 0, 0);
  add_pose(optimizer, 1, 0, 0, 0);
  auto e = std::make_unique<g2o::EdgeSE2PointXY>();
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  EXPECT_FALSE(optimizer.addEdge(e.get()));
  expect_message("do not have the types that the edge expects");
  EXPECT_TRUE(optimizer.vertex(0)->edges().empty());
}

TEST_F(Misuse, AnEdgeWithoutItsParameterIsRefused) {
  add_pose(optimizer, 0, 0, 0, 0);
  auto* l = new g2o::VertexPointXY;
  l->setId(1);
  optimizer.addVertex(l);
  auto e = std::make_unique<g2o::EdgeSE2PointXYOffset>();
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  e->setParameterId(0, 5);
  EXPECT_FALSE(optimizer.addEdge(e.get()));
  expect_message("needs parameter 5");
  auto* offset = new g2o::ParameterSE2Offset;
  offset->setId(5);
  ASSERT_TRUE(optimizer.addParameter(offset));
  EXPECT_TRUE(optimizer.addEdge(e.get()));
  e.release();
}

TEST_F(Misuse, AMarginalizedVertexOfTheWrongDimensionIsRefused) {
  add_square(optimizer);
  optimizer.vertex(2)->setMarginalized(true);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      new g2o::BlockSolver_3_2(new g2o::LinearSolverEigen<g2o::BlockSolver_3_2::PoseMatrixType>())));
  optimizer.initializeOptimization();
  EXPECT_EQ(optimizer.optimize(1), 0);
  expect_message("marginalizes only vertices with 2 dimensions");
}

TEST_F(Misuse, TwoMarginalizedVerticesOfOneEdgeAreRefused) {
  add_square(optimizer);
  optimizer.vertex(2)->setMarginalized(true);
  optimizer.vertex(3)->setMarginalized(true);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  optimizer.initializeOptimization();
  EXPECT_EQ(optimizer.optimize(1), 0);
  expect_message("both marginalized");
}

TEST_F(Misuse, UnknownTagsNamesAndFilesAreReported) {
  EXPECT_EQ(g2o::Factory::instance()->construct("NO_SUCH_WORD"), nullptr);
  expect_message("tag NO_SUCH_WORD");
  EXPECT_EQ(g2o::RobustKernelFactory::instance()->construct("NoSuchKernel"), nullptr);
  expect_message("name NoSuchKernel");
  g2o::OptimizationAlgorithmProperty property;
  EXPECT_EQ(g2o::OptimizationAlgorithmFactory::instance()->construct("lm_nonsense", property), nullptr);
  expect_message("name lm_nonsense");
  std::istringstream file("NO_SUCH_WORD 1 2 3\nVERTEX_SE2 0 1 2 3\n");
  EXPECT_TRUE(optimizer.load(file));
  expect_message("unknown tag 'NO_SUCH_WORD'");
  EXPECT_NE(optimizer.vertex(0), nullptr);
  EXPECT_FALSE(optimizer.load("/no/such/file.g2o"));
  expect_message("cannot be opened");
}

TEST_F(Misuse, NullPointersAndElementsOutsideOfTheGraphAreRefused) {
  add_square(optimizer);
  g2o::VertexSE2 stranger;
  EXPECT_FALSE(optimizer.addVertex(static_cast<g2o::OptimizableGraph::Vertex*>(nullptr)));
  expect_message("addVertex: expected a vertex, got nullptr");
  EXPECT_FALSE(optimizer.addEdge(static_cast<g2o::OptimizableGraph::Edge*>(nullptr)));
  EXPECT_FALSE(optimizer.removeVertex(nullptr));
  EXPECT_FALSE(optimizer.removeVertex(&stranger));
  EXPECT_FALSE(optimizer.removeEdge(nullptr));
  EXPECT_FALSE(optimizer.detachVertex(nullptr));
  EXPECT_FALSE(optimizer.mergeVertices(nullptr, optimizer.vertex(0), true));
  EXPECT_FALSE(optimizer.mergeVertices(optimizer.vertex(0), nullptr, true));
  EXPECT_FALSE(optimizer.setEdgeVertex(nullptr, 0, optimizer.vertex(0)));
  EXPECT_FALSE(optimizer.changeId(nullptr, 3));
  EXPECT_FALSE(optimizer.addParameter(nullptr));
  expect_message("addParameter: expected a parameter with an id of at least 0, got nullptr");
  EXPECT_FALSE(optimizer.addPreIterationAction(nullptr));
  EXPECT_FALSE(optimizer.addPostIterationAction(nullptr));
  EXPECT_FALSE(optimizer.addComputeErrorAction(nullptr));
  expect_message("expected an action, got nullptr");
  EXPECT_FALSE(optimizer.load(static_cast<const char*>(nullptr)));
  EXPECT_FALSE(optimizer.save(static_cast<const char*>(nullptr)));
  expect_message("expected the name of a file, got nullptr");
  g2o::HyperGraph::VertexSet vertices = {nullptr, optimizer.vertex(0), optimizer.vertex(1)};
  EXPECT_TRUE(optimizer.initializeOptimization(vertices));
  EXPECT_EQ(optimizer.activeEdges().size(), 1u);
  g2o::HyperGraph::EdgeSet edges = {nullptr, *optimizer.edges().begin()};
  EXPECT_TRUE(optimizer.initializeOptimization(edges));
  EXPECT_EQ(optimizer.activeEdges().size(), 1u);
  EXPECT_EQ(optimizer.vertex(99), nullptr);
  EXPECT_EQ(optimizer.parameter(99), nullptr);
}

TEST_F(Misuse, OptimizingWithoutInitializationAlgorithmOrLinearSolverFails) {
  EXPECT_FALSE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(1), -1);
  expect_message("was initializeOptimization() called?");
  add_square(optimizer);
  EXPECT_EQ(optimizer.optimize(1), -1);
  expect_message("was initializeOptimization() called?");
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(1), -1);
  expect_message("no algorithm");
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      new g2o::BlockSolverX(static_cast<g2o::BlockSolverX::LinearSolverType*>(nullptr))));
  EXPECT_EQ(optimizer.optimize(1), -1);
  expect_message("the block solver has no linear solver");
}

TEST_F(Misuse, ElementsOutsideOfTheGraphAndInvalidPositionsAreReported) {
  add_square(optimizer);
  g2o::VertexSE2 v;
  g2o::EdgeSE2 e;
  EXPECT_FALSE(optimizer.removeVertex(&v));
  expect_message("removeVertex: expected a vertex of the graph");
  EXPECT_FALSE(optimizer.removeEdge(&e));
  expect_message("removeEdge: expected an edge of the graph");
  EXPECT_FALSE(optimizer.changeId(optimizer.vertex(1), 2));
  expect_message("changeId: the id 2 is taken");
  e.setVertex(5, &v);
  expect_message("setVertex: the edge has 2 vertices, got position 5");
  EXPECT_FALSE(e.setParameterId(7, 3));
  expect_message("setParameterId: expected an index below 0 (the number of parameters)");
  optimizer.update(nullptr);
  expect_message("update: expected a step");
  EXPECT_EQ((*g2o::HyperGraphActionLibrary::instance()->actionByName("draw"))(
                static_cast<g2o::HyperGraph::HyperGraphElement*>(nullptr), nullptr),
            nullptr);
}

TEST_F(Misuse, AMessageNamesTheEdgeWhoseErrorIsNotFinite) {
  for (g2o::OptimizationAlgorithm* algorithm : std::initializer_list<g2o::OptimizationAlgorithm*>{
           new g2o::OptimizationAlgorithmGaussNewton(make_solver()),
           new g2o::OptimizationAlgorithmLevenberg(make_solver()),
           new g2o::OptimizationAlgorithmDogleg(make_solver())}) {
    optimizer.clear();
    add_square(optimizer);
    auto* e = static_cast<g2o::EdgeSE2*>(*optimizer.vertex(2)->edges().begin());
    e->setMeasurement(g2o::SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0));
    optimizer.setAlgorithm(algorithm);
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_EQ(optimizer.optimize(3), 0);
    EXPECT_EQ(messages.size(), 1u);
    expect_message("the error of the edge EDGE_SE2 " + std::to_string(e->vertex(0)->id()) + " " +
                   std::to_string(e->vertex(1)->id()) + " is not finite");
  }
}

TEST_F(Misuse, AMessageNamesAVertexThatTheEdgesDoNotDetermine) {
  add_pose(optimizer, 7, 0, 0, 0);
  add_pose(optimizer, 8, 1, 0, 0);
  small_graph::add_motion(optimizer, 7, 8, g2o::SE2(1, 0, 0));
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(3), 0);
  expect_message("the linear system is not positive definite (at vertex ");
}

TEST_F(Misuse, DoglegRefusesInvalidProperties) {
  add_square(optimizer);
  for (const char* text : {"initialDelta=0", "initialLambda=-1", "lambdaFactor=0"}) {
    auto* dogleg = new g2o::OptimizationAlgorithmDogleg(make_solver());
    optimizer.setAlgorithm(dogleg);
    EXPECT_TRUE(dogleg->updatePropertiesFromString(text));
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_EQ(optimizer.optimize(1), -1);
    expect_message("dogleg: expected initialDelta and initialLambda above 0");
  }
}

TEST_F(Misuse, VerticesOfDifferentTypesAreNotMerged) {
  add_square(optimizer);
  auto* point = new g2o::VertexPointXY;
  point->setId(50);
  ASSERT_TRUE(optimizer.addVertex(point));
  EXPECT_FALSE(optimizer.mergeVertices(point, optimizer.vertex(2), true));
  expect_message("the vertices do not have the types that the edge expects");
  EXPECT_EQ(optimizer.edges().size(), 4u);
  EXPECT_EQ(optimizer.vertex(2)->edges().size(), 2u);
  EXPECT_TRUE(point->edges().empty());
}

TEST_F(Misuse, AnAlgorithmWithoutASolverCannotBeInitialized) {
  add_square(optimizer);
  ASSERT_TRUE(optimizer.initializeOptimization());
  using Solvers = std::unique_ptr<g2o::Solver>;
  using BlockSolvers = std::unique_ptr<g2o::BlockSolverBase>;
  for (g2o::OptimizationAlgorithm* algorithm : std::initializer_list<g2o::OptimizationAlgorithm*>{
           new g2o::OptimizationAlgorithmGaussNewton(Solvers()),
           new g2o::OptimizationAlgorithmLevenberg(static_cast<g2o::Solver*>(nullptr)),
           new g2o::OptimizationAlgorithmDogleg(BlockSolvers())}) {
    optimizer.setAlgorithm(algorithm);
    EXPECT_EQ(optimizer.optimize(1), -1);
    expect_message("without a solver");
    g2o::SparseBlockMatrix<g2o::MatrixX> inverse;
    EXPECT_FALSE(optimizer.computeMarginals(inverse, optimizer.vertex(1)));
  }
}

TEST_F(Misuse, MarginalsAreOnlyAvailableForOptimizedVertices) {
  using Blocks = std::vector<std::pair<int, int>>;
  add_square(optimizer);
  g2o::SparseBlockMatrix<g2o::MatrixX> covariance;
  EXPECT_FALSE(optimizer.computeMarginals(covariance, Blocks{{0, 0}}));
  expect_message("computeMarginals");
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  optimizer.vertex(0)->setFixed(true);
  ASSERT_TRUE(optimizer.initializeOptimization());
  ASSERT_EQ(optimizer.optimize(1), 1);
  EXPECT_FALSE(optimizer.computeMarginals(covariance, optimizer.vertex(0)));
  expect_message("expected a vertex that takes part in the optimization");
  EXPECT_FALSE(
      optimizer.computeMarginals(covariance, static_cast<const g2o::OptimizableGraph::Vertex*>(nullptr)));
  expect_message("expected a vertex that takes part in the optimization");
  EXPECT_FALSE(optimizer.computeMarginals(covariance, Blocks{{0, 99}}));
  expect_message("expected Hessian indices");
  EXPECT_FALSE(
      optimizer.computeMarginals(covariance, g2o::OptimizableGraph::VertexContainer{optimizer.vertex(0)}));
  expect_message("expected Hessian indices");
  EXPECT_TRUE(optimizer.computeMarginals(covariance, optimizer.vertex(1)));
}

TEST_F(Misuse, SavingAParameterWithoutATagIsReported) {
  struct Unregistered : g2o::ParameterSE2Offset {};
  auto* p = new Unregistered;
  p->setId(3);
  ASSERT_TRUE(optimizer.addParameter(p));
  std::ostringstream out;
  EXPECT_FALSE(optimizer.save(out));
  expect_message("no tag is registered");
  EXPECT_EQ(out.str(), "");
}

TEST_F(Misuse, SavingAVertexWithoutATagIsReported) {
  struct Unregistered : g2o::VertexSE2 {};
  auto* v = new Unregistered;
  v->setId(3);
  ASSERT_TRUE(optimizer.addVertex(v));
  std::ostringstream out;
  EXPECT_FALSE(optimizer.save(out));
  expect_message("no tag is registered");
  EXPECT_EQ(out.str(), "");
}

TEST_F(Misuse, LinesThatCannotBeReadAreReportedAndAllOtherLinesAreRead) {
  const std::vector<std::string> lines = {
      "VERTEX_SE2 1 1 2",
      "VERTEX_SE2 1 nan 2 3",
      "VERTEX_SE2 0 1 2 3",
      "VERTEX_SE2 -4 1 2 3",
      "FIX 99",
      "EDGE_SE2 0 99 1 0 0 1 0 0 1 0 1",
      "EDGE_SE2 0 5 1 0 0 1 0 0 1 0",
      "EDGE_SE2 0 5 1 0 0 -1 0 0 1 0 1",
      "EDGE_SE2_XY 0 5 1 0 1 0 1",
      "EDGE_SE2_POINTXY_OFFSET 0 6 3 1 0 1 0 1",
  };
  for (const std::string& line : lines) {
    SCOPED_TRACE(line);
    optimizer.clear();
    std::istringstream file("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 5 1 0 0\nVERTEX_XY 6 1 0\n" + line +
                            "\n# a comment\n\nEDGE_SE2 0 5 1 0 0 1 0 0 1 0 1\n");
    EXPECT_FALSE(optimizer.load(file));
    expect_message("line 4");
    EXPECT_EQ(optimizer.edges().size(), 1u);
    EXPECT_EQ(optimizer.vertices().size(), 3u);
  }
}

/// Calls change() with an initialized optimizer, then optimize(). Ends the process with exit code 0 if
/// optimize() returns −1.
template <class Change>
void optimize_after(Change change) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  optimizer.initializeOptimization();
  change(optimizer);
  _exit(optimizer.optimize(1) == -1 ? 0 : 1);
}

TEST(WithoutASink, StderrSaysThatThereIsNoInitialization) {
  if (boxplus::is_emulated()) GTEST_SKIP() << "an emulated program cannot start itself again";
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // in a new process, which has set no sink
  const auto expect_error = [](auto change) {
    EXPECT_EXIT(optimize_after(change), testing::ExitedWithCode(0),
                "g2o: optimize: no vertices to optimize; was initializeOptimization\\(\\) called");
  };
  const auto forget = [](g2o::SparseOptimizer& optimizer) { optimizer.initializeOptimization(7); };
  expect_error(forget);  // no edge has level 7
  expect_error([](g2o::SparseOptimizer& optimizer) { optimizer.removeVertex(optimizer.vertex(3)); });
  expect_error([](g2o::SparseOptimizer& optimizer) { optimizer.clear(); });
}

}  // namespace
