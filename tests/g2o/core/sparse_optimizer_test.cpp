// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/sparse_optimizer.h"

#include <gmock/gmock.h>

#include <cmath>

#include "g2o/core/estimate_propagator.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/small_graph.h"
#include "g2o/core/sparse_optimizer_terminate_action.h"

namespace {

using small_graph::add_motion;
using small_graph::add_pose;
using small_graph::add_square;
using small_graph::make_solver;

class Optimizer : public testing::Test {
 protected:
  void use_gauss_newton() {
    optimizer.setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmGaussNewton>(make_solver()));
  }
  void use_levenberg() {
    optimizer.setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmLevenberg>(make_solver()));
  }
  /// Optimizes and returns the final chi2.
  double optimum() {
    optimizer.optimize(20);
    optimizer.computeActiveErrors();
    return optimizer.activeChi2();
  }
  const g2o::SE2& pose(int id) { return static_cast<g2o::VertexSE2*>(optimizer.vertex(id))->estimate(); }
  /// The Hessian as a dense matrix.
  Eigen::MatrixXd dense_hessian(g2o::BlockSolverBase& solver) {
    const auto n = static_cast<Eigen::Index>(solver.vectorSize());
    Eigen::MatrixXd H(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, i);
      solver.multiplyHessian(H.col(i).data(), unit.data());
    }
    return H;
  }
  g2o::SparseOptimizer optimizer;
};

/// A client's optimizer that counts the steps.
class CountingOptimizer : public g2o::SparseOptimizer {
 public:
  void update(const double* step) override {
    ++steps;
    g2o::SparseOptimizer::update(step);
  }
  int steps = 0;
};

TEST(ClientOptimizer, MayOverrideUpdateWhichEveryAlgorithmCalls) {
  for (g2o::OptimizationAlgorithm* algorithm : std::initializer_list<g2o::OptimizationAlgorithm*>{
           new g2o::OptimizationAlgorithmGaussNewton(make_solver()),
           new g2o::OptimizationAlgorithmLevenberg(make_solver()),
           new g2o::OptimizationAlgorithmDogleg(make_solver())}) {
    CountingOptimizer optimizer;
    add_square(optimizer);
    optimizer.setAlgorithm(algorithm);
    optimizer.initializeOptimization();
    EXPECT_EQ(optimizer.optimize(1), 1);
    EXPECT_GE(optimizer.steps, 1);
  }
}

TEST_F(Optimizer, AllAlgorithmsFindTheSameMinimum) {
  add_square(optimizer);
  optimizer.initializeOptimization();
  use_gauss_newton();
  const double chi2 = optimum();
  EXPECT_GT(chi2, 0);
  for (const int algorithm : {1, 2}) {
    g2o::SparseOptimizer other;
    add_square(other);
    if (algorithm == 1) other.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
    if (algorithm == 2) other.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(make_solver()));
    other.initializeOptimization();
    EXPECT_GT(other.optimize(50), 0);
    other.computeActiveErrors();
    EXPECT_NEAR(other.activeChi2(), chi2, 1e-9 * chi2);
  }
}

TEST_F(Optimizer, Chi2IsZeroUntilTheErrorsAreComputed) {
  add_square(optimizer);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.chi2(), 0);
  EXPECT_EQ(optimizer.activeChi2(), 0);
  optimizer.computeActiveErrors();
  EXPECT_GT(optimizer.chi2(), 0);
}

TEST_F(Optimizer, FixedVerticesDoNotMoveAndHaveNoHessianIndex) {
  add_square(optimizer);
  optimizer.vertex(2)->setFixed(true);
  const Eigen::Vector3d before = pose(2).toVector();
  use_gauss_newton();
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(3), 3);
  EXPECT_EQ(pose(2).toVector(), before);
  EXPECT_EQ(optimizer.vertex(2)->hessianIndex(), -1);
  EXPECT_EQ(optimizer.indexMapping().size(), 2u);
  EXPECT_EQ(optimizer.activeVertices().size(), 4u);
}

TEST_F(Optimizer, OnlyTheEdgesOfTheInitializedLevelTakePart) {
  add_square(optimizer);
  auto* wrong = add_motion(optimizer, 0, 2, g2o::SE2(9, 9, 0), 1000);
  wrong->setLevel(1);
  use_gauss_newton();
  optimizer.initializeOptimization(0);
  EXPECT_EQ(optimizer.activeEdges().size(), 4u);
  EXPECT_LT(optimum(), 1);
  EXPECT_EQ(wrong->error().norm(), 0) << "an edge of another level is not evaluated";
  optimizer.initializeOptimization(1);
  EXPECT_EQ(optimizer.activeEdges().size(), 1u);
  optimizer.initializeOptimization(-1);
  EXPECT_EQ(optimizer.activeEdges().size(), 5u);
}

TEST_F(Optimizer, UsesTheEdgesBetweenTheVerticesThatItIsInitializedWith) {
  add_square(optimizer);
  use_gauss_newton();
  g2o::HyperGraph::VertexSet vertices{optimizer.vertex(0), optimizer.vertex(1), optimizer.vertex(2)};
  ASSERT_TRUE(optimizer.initializeOptimization(vertices));
  EXPECT_EQ(optimizer.activeEdges().size(), 2u);
  const Eigen::Vector3d before = pose(3).toVector();
  EXPECT_LT(optimum(), 1e-12);
  EXPECT_EQ(pose(3).toVector(), before);
}

TEST_F(Optimizer, UsesTheVerticesOfTheEdgesThatItIsInitializedWith) {
  add_square(optimizer);
  use_gauss_newton();
  g2o::HyperGraph::EdgeSet edges;
  for (auto* e : optimizer.edges()) {
    if (e->vertex(0)->id() < 2) edges.insert(e);
  }
  ASSERT_TRUE(optimizer.initializeOptimization(edges));
  EXPECT_EQ(optimizer.activeVertices().size(), 3u);
  EXPECT_LT(optimum(), 1e-12);
}

TEST_F(Optimizer, RobustKernelsReduceTheInfluenceOfOutliers) {
  add_square(optimizer);
  auto* wrong = add_motion(optimizer, 0, 2, g2o::SE2(5, 5, 0), 10);
  auto* kernel = new g2o::RobustKernelHuber;
  kernel->setDelta(0.1);
  wrong->setRobustKernel(kernel);
  use_levenberg();
  optimizer.initializeOptimization();
  optimum();
  EXPECT_LT(optimizer.activeRobustChi2(), 0.1 * optimizer.activeChi2());
  EXPECT_LT((pose(2).translation() - Eigen::Vector2d(1, 1)).norm(), 0.5);
  wrong->setRobustKernel(nullptr);
  EXPECT_EQ(optimizer.activeRobustChi2(), optimizer.activeChi2());
}

TEST_F(Optimizer, AStopFlagStopsTheRun) {
  add_square(optimizer);
  use_gauss_newton();
  optimizer.initializeOptimization();
  bool stop = true;
  optimizer.setForceStopFlag(&stop);
  EXPECT_EQ(optimizer.optimize(10), 0);
  stop = false;
  EXPECT_EQ(optimizer.optimize(10), 10);
}

TEST_F(Optimizer, ActionsAreCalledAtTheInitializationAndBeforeAndAfterEachIteration) {
  struct Recorder : g2o::HyperGraphAction {
    std::vector<int> iterations;
    g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters* parameters) override {
      iterations.push_back(static_cast<ParametersIteration*>(parameters)->iteration);
      return this;
    }
  };
  Recorder before, after;
  add_square(optimizer);
  use_gauss_newton();
  EXPECT_TRUE(optimizer.addPreIterationAction(&before));
  EXPECT_FALSE(optimizer.addPreIterationAction(&before));
  EXPECT_TRUE(optimizer.addPostIterationAction(&after));
  optimizer.initializeOptimization();
  optimizer.optimize(2);
  EXPECT_THAT(before.iterations, testing::ElementsAre(-1, 0, 1));
  EXPECT_THAT(after.iterations, testing::ElementsAre(-1, 0, 1));
  EXPECT_TRUE(optimizer.removePreIterationAction(&before));
  optimizer.optimize(1);
  EXPECT_EQ(before.iterations.size(), 3u);
}

TEST_F(Optimizer, PopRestoresPushedEstimatesAndDiscardTopKeepsTheCurrentEstimates) {
  add_square(optimizer);
  use_gauss_newton();
  optimizer.initializeOptimization();
  const Eigen::Vector3d before = pose(2).toVector();
  optimizer.push();
  optimizer.optimize(5);
  EXPECT_NE(pose(2).toVector(), before);
  optimizer.pop();
  EXPECT_EQ(pose(2).toVector(), before);
  optimizer.push();
  optimizer.optimize(5);
  optimizer.discardTop();
  EXPECT_NE(pose(2).toVector(), before);
  EXPECT_EQ(optimizer.vertex(2)->stackSize(), 0);
}

TEST_F(Optimizer, StatisticsDescribeEveryIteration) {
  add_square(optimizer);
  use_levenberg();
  optimizer.setComputeBatchStatistics(true);
  optimizer.initializeOptimization();
  const int iterations = optimizer.optimize(4);
  ASSERT_EQ(optimizer.batchStatistics().size(), static_cast<size_t>(iterations));
  const g2o::G2OBatchStatistics& first = optimizer.batchStatistics().front();
  EXPECT_EQ(first.iteration, 0);
  EXPECT_EQ(first.numEdges, 4);
  EXPECT_EQ(first.numVertices, 4);
  EXPECT_EQ(first.hessianDimension, 9u);
  EXPECT_GT(first.levenbergIterations, 0);
  EXPECT_GT(first.timeIteration, 0);
  EXPECT_GT(first.timeUpdate, 0);
  EXPECT_GT(first.timeLinearSolver, 0);
  EXPECT_LE(first.timeLinearSolver, first.timeLinearSolution);
  g2o::SparseBlockMatrix<g2o::MatrixX> inverse;
  EXPECT_TRUE(optimizer.computeMarginals(inverse, optimizer.vertex(1)));
  EXPECT_GT(optimizer.batchStatistics().back().timeMarginals, 0);
  EXPECT_NEAR(optimizer.batchStatistics().back().chi2, optimizer.activeChi2(), 1e-12);
}

TEST_F(Optimizer, AStopFlagThatIsSetInTheFirstIterationStopsTheRunDespiteATerminateAction) {
  add_square(optimizer);
  use_gauss_newton();
  bool stop = false;
  g2o::SparseOptimizerTerminateAction terminate;
  terminate.setGainThreshold(-1);
  optimizer.setForceStopFlag(&stop);
  optimizer.addPostIterationAction(&terminate);
  struct Raise : g2o::HyperGraphAction {
    bool* stop = nullptr;
    g2o::HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters* parameters) override {
      const auto* iteration = dynamic_cast<const ParametersIteration*>(parameters);
      if (iteration != nullptr && iteration->iteration == 0) *stop = true;
      return this;
    }
  } raise;
  raise.stop = &stop;
  optimizer.addPreIterationAction(&raise);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(20), 1);
}

TEST_F(Optimizer, MarginalsAreRefusedAfterTheStructureChangedUntilTheNextRun) {
  add_square(optimizer);
  auto* algorithm = new g2o::OptimizationAlgorithmGaussNewton(make_solver());
  optimizer.setAlgorithm(algorithm);
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.optimize(5);
  g2o::SparseBlockMatrix<g2o::MatrixX> marginals;
  EXPECT_TRUE(optimizer.computeMarginals(marginals, optimizer.vertex(3)));
  optimizer.vertex(1)->setFixed(true);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_FALSE(optimizer.computeMarginals(marginals, optimizer.vertex(3)));
  ASSERT_TRUE(algorithm->buildLinearStructure());
  EXPECT_FALSE(optimizer.computeMarginals(marginals, optimizer.vertex(3)))
      << "the new structure is not linearized yet";
  optimizer.optimize(1);
  EXPECT_TRUE(optimizer.computeMarginals(marginals, optimizer.vertex(3)));
}

TEST_F(Optimizer, AnActiveVertexIsFoundAfterItsIdChanged) {
  add_square(optimizer);
  use_gauss_newton();
  ASSERT_TRUE(optimizer.initializeOptimization());
  optimizer.optimize(1);
  g2o::OptimizableGraph::Vertex* v = optimizer.vertex(1);
  ASSERT_TRUE(optimizer.changeId(v, 100));
  EXPECT_FALSE(optimizer.addVertex(v));
  g2o::HyperGraph::VertexSet vertices{v};
  g2o::HyperGraph::EdgeSet edges;
  EXPECT_TRUE(optimizer.updateInitialization(vertices, edges));
  EXPECT_EQ(std::count(optimizer.activeVertices().begin(), optimizer.activeVertices().end(), v), 1);
  EXPECT_TRUE(optimizer.removeVertex(v));
  EXPECT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(1), 1);
}

TEST_F(Optimizer, MarginalsAreBlocksOfTheInverseHessianWithoutDamping) {
  for (const bool marginalize : {false, true}) {
    g2o::SparseOptimizer graph;
    add_square(graph);
    auto* landmark = new g2o::VertexPointXY;
    landmark->setId(10);
    landmark->setMarginalized(marginalize);
    graph.addVertex(landmark);
    for (int i = 0; i < 4; ++i) {
      auto* e = new g2o::EdgeSE2PointXY;
      e->setVertex(0, graph.vertex(i));
      e->setVertex(1, landmark);
      e->setMeasurementFromState();
      e->setInformation(Eigen::Matrix2d::Identity() * (2 + i));
      ASSERT_TRUE(graph.addEdge(e));
    }
    auto solver = make_solver();
    g2o::BlockSolverX& blocks = *solver;
    graph.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::move(solver)));
    ASSERT_TRUE(graph.initializeOptimization());
    ASSERT_GT(graph.optimize(10), 0);
    EXPECT_EQ(blocks.schur(), marginalize);
    const Eigen::MatrixXd covariance = dense_hessian(blocks).inverse();
    std::vector<std::pair<int, int>> wanted;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) wanted.emplace_back(i, j);
    g2o::SparseBlockMatrix<g2o::MatrixX> marginals;
    ASSERT_TRUE(graph.computeMarginals(marginals, wanted));
    const double scale = covariance.cwiseAbs().maxCoeff();
    for (const auto& [i, j] : wanted) {
      const Eigen::MatrixXd expected =
          covariance.block(marginals.rowBaseOfBlock(i), marginals.colBaseOfBlock(j), marginals.rowsOfBlock(i),
                           marginals.colsOfBlock(j));
      EXPECT_LT((*marginals.block(i, j) - expected).cwiseAbs().maxCoeff(), 1e-8 * scale);
    }
    g2o::SparseBlockMatrix<g2o::MatrixX> one;
    ASSERT_TRUE(graph.computeMarginals(one, graph.vertex(1)));
    EXPECT_EQ(one.nonZeroBlocks(), 1u);
    EXPECT_FALSE(graph.computeMarginals(one, graph.vertex(0))) << "a fixed vertex has no marginal covariance";
  }
}

TEST_F(Optimizer, VerticesHaveTheirHessianBlockAndAZeroGradientAtTheMinimum) {
  add_square(optimizer);
  auto solver = make_solver();
  g2o::BlockSolverX& blocks = *solver;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(std::move(solver)));
  optimizer.initializeOptimization();
  optimizer.optimize(20);
  const Eigen::MatrixXd H = dense_hessian(blocks);
  const auto* v = optimizer.vertex(2);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(v->hessian(i, j), H(v->colInHessian() + i, v->colInHessian() + j));
    EXPECT_NEAR(v->b(i), 0, 1e-9);
  }
}

TEST_F(Optimizer, TheHessianOfAVertexStaysReadableWhenTheSolverIsReplaced) {
  add_square(optimizer);
  EXPECT_TRUE(std::isnan(optimizer.vertex(2)->hessian(0, 0))) << "nothing was optimized yet";
  EXPECT_TRUE(std::isnan(optimizer.vertex(2)->hessianDeterminant()));
  use_gauss_newton();
  optimizer.initializeOptimization();
  optimizer.optimize(1);
  const double before = optimizer.vertex(2)->hessian(0, 0);
  EXPECT_GT(before, 0);
  use_levenberg();
  EXPECT_EQ(optimizer.vertex(2)->hessian(0, 0), before);
  optimizer.setAlgorithm(nullptr);
  EXPECT_EQ(optimizer.vertex(2)->hessian(0, 0), before);
  use_levenberg();
  optimizer.optimize(1);
  EXPECT_GT(optimizer.vertex(2)->hessian(0, 0), 0);
}

TEST_F(Optimizer, AVertexThatNoLongerTakesPartHasNoHessian) {
  add_square(optimizer);
  use_gauss_newton();
  optimizer.initializeOptimization();
  optimizer.optimize(1);
  g2o::HyperGraph::VertexSet two{optimizer.vertex(0), optimizer.vertex(1)};
  ASSERT_TRUE(optimizer.initializeOptimization(two));
  EXPECT_EQ(optimizer.optimize(1), 1);
  EXPECT_GT(optimizer.vertex(1)->hessian(0, 0), 0);
  EXPECT_TRUE(std::isnan(optimizer.vertex(2)->hessian(0, 0)));
}

TEST_F(Optimizer, AnInitialGuessFollowsTheEdgesFromTheFixedVertices) {
  add_square(optimizer);
  for (int i = 1; i < 4; ++i) optimizer.vertex(i)->setToOrigin();
  optimizer.initializeOptimization();
  optimizer.computeInitialGuess();
  EXPECT_LT((pose(1).translation() - Eigen::Vector2d(1, 0.01)).norm(), 1e-12);
  optimizer.computeActiveErrors();
  EXPECT_LT(optimizer.activeChi2(), 1);
  for (int i = 1; i < 4; ++i) optimizer.vertex(i)->setToOrigin();
  g2o::EstimatePropagatorCostOdometry odometry(&optimizer);
  optimizer.computeInitialGuess(odometry);
  EXPECT_LT((pose(3).translation() - Eigen::Vector2d(0, 1)).norm(), 0.1);
}

TEST_F(Optimizer, GaugeFreedomIsFoundUnlessAFixedVertexOrAPriorRemovesIt) {
  EXPECT_EQ(optimizer.findGauge(), nullptr);
  add_square(optimizer);
  EXPECT_FALSE(optimizer.gaugeFreedom());
  optimizer.vertex(0)->setFixed(false);
  EXPECT_TRUE(optimizer.gaugeFreedom());
  EXPECT_EQ(optimizer.findGauge(), optimizer.vertex(0));
  auto* prior = new g2o::EdgeSE2Prior;
  prior->setVertex(0, optimizer.vertex(2));
  prior->setMeasurement(g2o::SE2(1, 1, 3));
  ASSERT_TRUE(optimizer.addEdge(prior));
  EXPECT_FALSE(optimizer.gaugeFreedom());
}

TEST_F(Optimizer, AGrowingGraphIsUpdatedWithoutANewInitialization) {
  add_square(optimizer);
  use_gauss_newton();
  optimizer.initializeOptimization();
  optimizer.optimize(3);
  g2o::HyperGraph::VertexSet vertices{add_pose(optimizer, 4, 1.5, 0.2, 0)};
  g2o::HyperGraph::EdgeSet edges{add_motion(optimizer, 3, 4, g2o::SE2(1, 0, 1.5)),
                                 add_motion(optimizer, 0, 4, g2o::SE2(0.1, 0, 0))};
  ASSERT_TRUE(optimizer.updateInitialization(vertices, edges));
  EXPECT_EQ(optimizer.optimize(10, true), 10);
  optimizer.computeActiveErrors();
  const double online = optimizer.activeChi2();
  optimizer.initializeOptimization();
  EXPECT_NEAR(optimum(), online, 1e-9 * online);
}

TEST_F(Optimizer, AClearedOptimizerCanBeUsedAgain) {
  use_levenberg();
  double first = 0;
  for (int cycle = 0; cycle < 5; ++cycle) {
    add_square(optimizer);
    ASSERT_TRUE(optimizer.initializeOptimization());
    const double chi2 = optimum();
    if (cycle == 0) first = chi2;
    EXPECT_EQ(chi2, first);
    optimizer.clear();
    EXPECT_EQ(optimizer.optimize(1), -1);
  }
}

TEST_F(Optimizer, VerifyInformationMatricesFindsIndefiniteAndAsymmetricMatrices) {
  add_square(optimizer);
  EXPECT_TRUE(optimizer.verifyInformationMatrices());
  auto* e = add_motion(optimizer, 0, 2, g2o::SE2());
  e->setInformation(Eigen::Matrix3d(Eigen::Vector3d(1, -1, 1).asDiagonal()));
  EXPECT_FALSE(optimizer.verifyInformationMatrices(true));
  Eigen::Matrix3d skew = Eigen::Matrix3d::Identity();
  skew(0, 1) = 0.5;
  e->setInformation(skew);
  EXPECT_FALSE(optimizer.verifyInformationMatrices());
}

}  // namespace
