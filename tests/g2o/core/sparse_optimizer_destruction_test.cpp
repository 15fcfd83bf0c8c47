// SPDX-License-Identifier: BSD-3-Clause
// Vertices, edges, actions and algorithms are removed or destroyed while an optimizer uses them. Meant to run
// under AddressSanitizer.
#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/core/sparse_optimizer_terminate_action.h"
#include "g2o/solvers/structure_only/structure_only_solver.h"
#include "g2o/stuff/logger.h"

namespace {

using small_graph::add_motion;
using small_graph::add_pose;
using small_graph::add_square;
using small_graph::make_solver;

class Destruction : public testing::Test {
 protected:
  void SetUp() override {
    optimizer.setAlgorithm(algorithm);
    add_square(optimizer);
    ASSERT_TRUE(optimizer.initializeOptimization());
  }
  /// The minimum chi2 of the graph that add_square() builds.
  double optimum() {
    g2o::SparseOptimizer fresh;
    fresh.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
    add_square(fresh);
    fresh.initializeOptimization();
    fresh.optimize(10);
    fresh.computeActiveErrors();
    return fresh.activeChi2();
  }
  g2o::OptimizationAlgorithmGaussNewton* algorithm = new g2o::OptimizationAlgorithmGaussNewton(make_solver());
  g2o::SparseOptimizer optimizer;
};

TEST_F(Destruction, TheSolverRefusesToSolveAfterClear) {
  optimizer.optimize(2);
  optimizer.clear();
  g2o::SparseBlockMatrix<g2o::MatrixX> spinv;
  const std::vector<std::pair<int, int>> first{{0, 0}};
  EXPECT_FALSE(optimizer.computeMarginals(spinv, first));
  EXPECT_FALSE(algorithm->computeMarginals(spinv, first));
  EXPECT_FALSE(algorithm->solver().buildSystem());
  EXPECT_FALSE(algorithm->solver().solve());
  EXPECT_EQ(optimizer.optimize(1), -1);
}

TEST_F(Destruction, AnOnlineRunAfterClearBuildsTheStructureOfTheNewGraph) {
  optimizer.optimize(2);
  optimizer.clear();
  add_square(optimizer);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(10, true), 10);
  optimizer.computeActiveErrors();
  EXPECT_NEAR(optimizer.activeChi2(), optimum(), 1e-12);
}

TEST_F(Destruction, TheFirstRunMayBeOnline) {
  EXPECT_EQ(optimizer.optimize(10, true), 10);
  optimizer.computeActiveErrors();
  EXPECT_NEAR(optimizer.activeChi2(), optimum(), 1e-12);
}

TEST_F(Destruction, TheGraphMayGrowBeforeTheFirstRun) {
  g2o::HyperGraph::VertexSet vertices{add_pose(optimizer, 9, 2, 1, 0)};
  g2o::HyperGraph::EdgeSet edges{add_motion(optimizer, 2, 9, g2o::SE2(-1, 0, 3))};
  EXPECT_TRUE(optimizer.updateInitialization(vertices, edges));
  EXPECT_EQ(optimizer.optimize(2, true), 2);
  EXPECT_EQ(optimizer.indexMapping().size(), 4u);
}

TEST_F(Destruction, AGraphWithAMarginalizedVertexMayGrowByAVertexThatIsNotMarginalized) {
  optimizer.vertex(2)->setMarginalized(true);
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.optimize(1);
  g2o::VertexSE2* added = add_pose(optimizer, -7, 1, 1, 0);
  g2o::HyperGraph::VertexSet vertices{added};
  g2o::HyperGraph::EdgeSet edges{add_motion(optimizer, 3, -7, g2o::SE2(1, 0, 0)),
                                 add_motion(optimizer, 1, -7, g2o::SE2(1, 1, 0))};
  ASSERT_TRUE(optimizer.updateInitialization(vertices, edges));
  EXPECT_EQ(optimizer.vertex(2)->hessianIndex(), 3) << "marginalized vertices come last";
  EXPECT_EQ(*optimizer.findActiveVertex(added), added);
  EXPECT_EQ(optimizer.optimize(10, true), 10);
  optimizer.computeActiveErrors();
  const double grown = optimizer.activeChi2();
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(10), 10);
  optimizer.computeActiveErrors();
  EXPECT_NEAR(optimizer.activeChi2(), grown, 1e-9);
}

TEST_F(Destruction, EdgesOfADetachedVertexNoLongerTakePartInTheOptimization) {
  optimizer.optimize(1);
  EXPECT_TRUE(optimizer.detachVertex(optimizer.vertex(1)));
  EXPECT_EQ(optimizer.activeEdges().size(), 2u);
  optimizer.computeActiveErrors();
  EXPECT_TRUE(optimizer.removeVertex(optimizer.vertex(3), true));
  EXPECT_TRUE(optimizer.activeEdges().empty());
  EXPECT_EQ(optimizer.edges().size(), 4u);
  optimizer.computeActiveErrors();
  EXPECT_EQ(optimizer.activeChi2(), 0);
  EXPECT_EQ(optimizer.optimize(1), -1);
}

TEST_F(Destruction, AnActiveEdgeGetsAnotherHessianBlockIfItsVertexIsReplaced) {
  optimizer.optimize(1);
  g2o::EdgeSE2* diagonal = add_motion(optimizer, 0, 2, g2o::SE2(1, 1, 3.1));
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.optimize(10);
  diagonal->setMeasurement(g2o::SE2(1, 0, 1.5));
  ASSERT_TRUE(optimizer.setEdgeVertex(diagonal, 1, optimizer.vertex(1)));
  EXPECT_EQ(optimizer.optimize(10, true), 10);
  optimizer.computeActiveErrors();
  const double online = optimizer.activeChi2();
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(10), 10);
  optimizer.computeActiveErrors();
  EXPECT_NEAR(optimizer.activeChi2(), online, 1e-12);
}

TEST_F(Destruction, AnEdgeRefusesAVertexOfAnotherGraph) {
  g2o::SparseOptimizer other;
  g2o::VertexSE2* foreign = add_pose(other, 77, 0, 0, 0);
  auto* e = static_cast<g2o::EdgeSE2*>(*optimizer.edges().begin());
  const g2o::HyperGraph::VertexContainer before = e->vertices();
  EXPECT_FALSE(optimizer.setEdgeVertex(e, 0, foreign));
  EXPECT_EQ(e->vertices(), before);
  EXPECT_TRUE(foreign->edges().empty());
}

TEST_F(Destruction, AnActionThatStoppedARunDoesNotStopTheNextRun) {
  auto action = std::make_unique<g2o::SparseOptimizerTerminateAction>();
  optimizer.addPostIterationAction(action.get());
  EXPECT_LT(optimizer.optimize(50), 50);
  EXPECT_TRUE(optimizer.terminate());
  optimizer.removePostIterationAction(action.get());
  action.reset();
  EXPECT_EQ(optimizer.optimize(3), 3);
}

/// An action that removes and deletes itself when it is called.
class Once : public g2o::HyperGraphAction {
 public:
  Once(g2o::SparseOptimizer& optimizer, int& calls) : optimizer_(optimizer), calls_(calls) {}
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    ++calls_;
    optimizer_.removePreIterationAction(this);
    optimizer_.removePostIterationAction(this);
    optimizer_.removeComputeErrorAction(this);
    delete this;
    return nullptr;
  }

 private:
  g2o::SparseOptimizer& optimizer_;
  int& calls_;
};

TEST_F(Destruction, ActionsMayRemoveAndDeleteThemselves) {
  int calls = 0;
  for (int i = 0; i < 3; ++i) {
    optimizer.addPreIterationAction(new Once(optimizer, calls));
    optimizer.addPostIterationAction(new Once(optimizer, calls));
    optimizer.addComputeErrorAction(new Once(optimizer, calls));
  }
  EXPECT_EQ(optimizer.optimize(3), 3);
  EXPECT_EQ(calls, 9);
}

/// An action that removes the algorithm of the optimizer.
class Thief : public g2o::HyperGraphAction {
 public:
  explicit Thief(g2o::SparseOptimizer& optimizer) : optimizer_(optimizer) {}
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    optimizer_.setAlgorithm(nullptr);
    return this;
  }

 private:
  g2o::SparseOptimizer& optimizer_;
};

TEST_F(Destruction, ARunEndsWhenAnActionRemovesItsAlgorithm) {
  Thief thief(optimizer);
  optimizer.addPostIterationAction(&thief);
  EXPECT_EQ(optimizer.optimize(3), 1);
}

/// An action that removes another action from the optimizer and deletes it.
class Remover : public g2o::HyperGraphAction {
 public:
  explicit Remover(g2o::SparseOptimizer& optimizer) : optimizer_(optimizer) {}
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    if (other == nullptr) return this;
    other->other = nullptr;
    optimizer_.removePostIterationAction(other);
    delete std::exchange(other, nullptr);
    return this;
  }
  Remover* other = nullptr;

 private:
  g2o::SparseOptimizer& optimizer_;
};

TEST_F(Destruction, AnActionThatAnotherActionDeletedIsNotCalled) {
  auto *a = new Remover(optimizer), *b = new Remover(optimizer);
  a->other = b;
  b->other = a;
  const std::less<g2o::HyperGraphAction*> before;
  Remover* first = before(a, b) ? a : b;
  optimizer.addPostIterationAction(a);
  optimizer.addPostIterationAction(b);
  EXPECT_EQ(optimizer.optimize(2), 2);
  EXPECT_TRUE(optimizer.removePostIterationAction(first))
      << "the first action removed only the second action";
  delete first;
}

/// An edge that removes itself from its vertices in its destructor.
class Leaving : public g2o::EdgeSE2 {
 public:
  ~Leaving() override {
    for (g2o::HyperGraph::Vertex* v : _vertices) {
      if (v != nullptr) v->edges().erase(this);
    }
  }
};

TEST(DestructionOfEdges, HappensBeforeTheirVerticesAreDestroyed) {
  for (const std::string how : {"clear", "destructor", "removeEdge", "removeVertex", "refused"}) {
    SCOPED_TRACE(how);
    g2o::SparseOptimizer optimizer;
    add_square(optimizer);
    auto e = std::make_unique<Leaving>();
    e->setVertex(0, optimizer.vertex(0));
    e->setVertex(1, optimizer.vertex(how == "refused" ? 0 : 2));
    EXPECT_EQ(optimizer.addEdge(e.get()), how != "refused");
    if (how == "refused") continue;
    g2o::HyperGraph::Edge* added = e.release();
    if (how == "clear") optimizer.clear();
    if (how == "removeEdge") {
      EXPECT_TRUE(optimizer.removeEdge(added));
    } else if (how == "removeVertex") {
      EXPECT_TRUE(optimizer.removeVertex(optimizer.vertex(2)));
    }
  }
}

TEST(DestructionOfData, HappensWithItsElementIfTheGraphAcceptedTheElement) {
  struct Note : g2o::HyperGraph::Data {
    explicit Note(int& living) : count(living) { ++count; }
    ~Note() override { --count; }
    bool read(std::istream&) override { return true; }
    bool write(std::ostream&) const override { return true; }
    int& count;
  };
  int living = 0;
  {
    g2o::SparseOptimizer optimizer;
    auto* taken = new Note(living);
    auto* v = new g2o::VertexSE2;
    v->setId(4);
    ASSERT_TRUE(optimizer.addVertex(v, taken));
    EXPECT_EQ(taken->dataContainer(), v);
    auto refused = std::make_unique<g2o::VertexSE2>();
    refused->setId(4);
    auto kept = std::make_unique<Note>(living);
    EXPECT_FALSE(optimizer.addVertex(refused.get(), kept.get()))
        << "the caller keeps the vertex and its data";
    EXPECT_EQ(kept->dataContainer(), nullptr);
    auto* in_front = new Note(living);
    in_front->setNext(v->userData());
    v->setUserData(in_front);
    EXPECT_EQ(in_front->dataContainer(), v);
    EXPECT_EQ(living, 3);
  }
  EXPECT_EQ(living, 0);
}

TEST(DestructionOfParameters, LeavesRefusedAndDetachedParametersToTheCaller) {
  g2o::SparseOptimizer optimizer;
  for (int id : {1, 2}) {
    auto* offset = new g2o::ParameterSE2Offset;
    offset->setId(id);
    ASSERT_TRUE(optimizer.addParameter(offset));
  }
  auto taken = std::make_unique<g2o::ParameterSE2Offset>();
  taken->setId(2);
  EXPECT_FALSE(optimizer.addParameter(taken.get()));
  const std::unique_ptr<g2o::Parameter> detached(optimizer.parameters().detachParameter(1));
  EXPECT_EQ(detached->id(), 1);
  EXPECT_EQ(optimizer.parameter(1), nullptr);
  optimizer.clear();
  EXPECT_NE(optimizer.parameter(2), nullptr) << "clear() keeps parameters";
  optimizer.clearParameters();
  EXPECT_EQ(optimizer.parameter(2), nullptr);
}

TEST(DestructionOfParameters, AnEdgeReturnsNullForAMissingParameter) {
  g2o::EdgeSE2PointXYOffset e;
  EXPECT_EQ(e.parameter(0), nullptr);
  EXPECT_EQ(e.parameter(5), nullptr);
}

TEST(NullPointers, AreRefusedForACreatorAnAlgorithmAndALinearSolver) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  g2o::OptimizationAlgorithmFactory::instance()->registerSolver(
      std::shared_ptr<g2o::AbstractOptimizationAlgorithmCreator>());
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  optimizer.initializeOptimization();
  EXPECT_EQ(optimizer.optimize(1), -1);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      new g2o::BlockSolverX(static_cast<g2o::BlockSolverX::LinearSolverType*>(nullptr))));
  EXPECT_EQ(optimizer.optimize(1), -1);
  EXPECT_THAT(messages, testing::Contains(testing::HasSubstr("no algorithm")));
  g2o::logging::setSink({});
}

TEST(StructureOnlySolver, IgnoresEdgesWithUnassignedVertices) {
  g2o::SparseOptimizer optimizer;
  add_pose(optimizer, 0, 0, 0, 0);
  auto* l = new g2o::VertexPointXY;
  l->setId(1);
  l->setEstimate(Eigen::Vector2d(1, 1));
  l->setMarginalized(true);
  ASSERT_TRUE(optimizer.addVertex(l));
  for (const bool is_assigned : {true, false}) {
    auto* e = new g2o::EdgeSE2PointXY;
    if (is_assigned) e->setVertex(0, optimizer.vertex(0));
    e->setVertex(1, l);
    e->setMeasurement(Eigen::Vector2d(2, 3));
    ASSERT_TRUE(optimizer.addUnassignedEdge(e));
  }
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.setAlgorithm(new g2o::StructureOnlySolver<2>);
  EXPECT_EQ(optimizer.optimize(10), 10);
  EXPECT_LT((l->estimate() - Eigen::Vector2d(2, 3)).norm(), 1e-3);
}

}  // namespace
