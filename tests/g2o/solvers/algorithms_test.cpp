// SPDX-License-Identifier: BSD-3-Clause
// Tests of the algorithms that the factory constructs, on small graphs.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <sstream>

#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

G2O_USE_OPTIMIZATION_LIBRARY(eigen)
G2O_USE_OPTIMIZATION_LIBRARY(dense)
G2O_USE_OPTIMIZATION_LIBRARY(pcg)
G2O_USE_OPTIMIZATION_LIBRARY(structure_only)
G2O_USE_OPTIMIZATION_LIBRARY(slam2d_linear)
G2O_USE_OPTIMIZATION_LIBRARY(cholmod)
G2O_USE_OPTIMIZATION_LIBRARY(csparse)
#ifdef G2O_TEST_SUITESPARSE_CHOLMOD
G2O_USE_OPTIMIZATION_LIBRARY(suitesparse_cholmod)
#endif
#ifdef G2O_TEST_SUITESPARSE_CSPARSE
G2O_USE_OPTIMIZATION_LIBRARY(suitesparse_csparse)
#endif

namespace {

using small_graph::add_square;

std::unique_ptr<g2o::OptimizationAlgorithm> construct(const std::string& name) {
  g2o::OptimizationAlgorithmProperty property;
  return std::unique_ptr<g2o::OptimizationAlgorithm>(
      g2o::OptimizationAlgorithmFactory::instance()->construct(name, property));
}

/// Adds a square of poses, and a point in its middle that all poses observe.
void add_square_with_point(g2o::SparseOptimizer& optimizer) {
  add_square(optimizer);
  auto* point = new g2o::VertexPointXY;
  point->setId(10);
  point->setEstimate(Eigen::Vector2d(0.6, 0.4));
  ASSERT_TRUE(optimizer.addVertex(point));
  for (int i = 0; i < 4; ++i) {
    auto* e = new g2o::EdgeSE2PointXY;
    e->setVertex(0, optimizer.vertex(i));
    e->setVertex(1, point);
    e->setMeasurement(Eigen::Vector2d(0.5, 0.5));
    e->setInformation(Eigen::Matrix2d::Identity() * 3);
    ASSERT_TRUE(optimizer.addEdge(e));
  }
}

/// Optimizes the square with the point, always from the same estimates. Returns the final chi2, or -1 if the
/// factory knows no algorithm with this name.
double final_chi2(const std::string& name, bool marginalize) {
  g2o::SparseOptimizer optimizer;
  add_square_with_point(optimizer);
  optimizer.vertex(10)->setMarginalized(marginalize);
  auto algorithm = construct(name);
  if (algorithm == nullptr) return -1;
  optimizer.setAlgorithm(std::move(algorithm));
  EXPECT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0) << name;
  optimizer.computeActiveErrors();
  return optimizer.activeChi2();
}

std::vector<std::string> names_with(const std::string& suffix) {
  return {"gn_var" + suffix,    "gn_fix3_2" + suffix, "gn_fix6_3" + suffix,
          "gn_fix7_3" + suffix, "lm_var" + suffix,    "lm_fix3_2" + suffix,
          "lm_fix6_3" + suffix, "lm_fix7_3" + suffix, "dl_var" + suffix};
}

TEST(Algorithms, TheFactoryListsAllAlgorithmsOfTheLinkedLibraries) {
  std::vector<std::string> wanted = {"2dlinear", "structure_only_2", "structure_only_3"};
  for (const char* linear : {"dense", "pcg"}) {
    for (const char* method : {"gn_", "lm_"}) {
      for (const char* blocks : {"", "3_2", "6_3", "7_3"})
        wanted.push_back(std::string(method) + linear + blocks);
    }
  }
  for (const char* suffix : {
           "",
           "_cholmod",
           "_csparse",
#ifdef G2O_TEST_SUITESPARSE_CHOLMOD
           "_suitesparse_cholmod",
#endif
#ifdef G2O_TEST_SUITESPARSE_CSPARSE
           "_suitesparse_csparse",
#endif
       }) {
    const auto names = names_with(suffix);
    wanted.insert(wanted.end(), names.begin(), names.end());
  }
  std::vector<std::string> found;
  for (const auto& creator : g2o::OptimizationAlgorithmFactory::instance()->creatorList())
    found.push_back(creator->property().name);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(wanted));
}

TEST(Algorithms, TheFactoryReturnsNullForAnUnknownName) {
  EXPECT_EQ(construct("lm_nonsense"), nullptr);
}

/// Algorithms whose names have this suffix. Those of SuiteSparse are opt-in.
class NamedSolver : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string suffix = GetParam();
    std::string option = "G2O_USE" + suffix;
    std::transform(option.begin(), option.end(), option.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    if (construct("gn_var" + suffix) == nullptr)
      GTEST_SKIP() << "the algorithms *" << suffix << " are not built, because " << option << " is OFF";
  }
};

TEST_P(NamedSolver, FindsTheSameMinimumAsTheSolverOfTheEngine) {
  const std::string suffix = GetParam();
  for (const std::string& name : {"gn_var" + suffix, "lm_var" + suffix, "dl_var" + suffix}) {
    SCOPED_TRACE(name);
    const double expected = final_chi2("lm_var", false);
    EXPECT_NEAR(final_chi2(name, false), expected, 1e-9 * expected);
    EXPECT_NEAR(final_chi2(name, true), expected, 1e-9 * expected);
  }
  const double expected = final_chi2("gn_fix3_2", true);
  EXPECT_NEAR(final_chi2("gn_fix3_2" + suffix, true), expected, 1e-9 * expected);
}

TEST_P(NamedSolver, SolvesPositiveDefiniteSystemsAndOnlyAsCholmodIndefiniteOnes) {
  using Matrix = g2o::SparseBlockMatrix<g2o::MatrixX>;
  auto algorithm = construct(std::string("gn_var") + GetParam());
  auto& solver = static_cast<g2o::OptimizationAlgorithmWithHessian&>(*algorithm).solver();
  auto& linear = static_cast<g2o::BlockSolverX&>(solver).linearSolver();
  const std::vector<int> ends = {2, 4};
  Matrix A(ends.data(), ends.data(), 2, 2);
  *A.block(0, 0, true) = Eigen::Matrix2d{{4, 1}, {1, 3}};
  *A.block(0, 1, true) = Eigen::Matrix2d{{1, 0}, {0.5, 1}};
  *A.block(1, 1, true) = Eigen::Matrix2d{{5, 0}, {0, 6}};
  Eigen::Vector4d x, b(1, 2, 3, 4), b_before = b;
  for (const bool by_blocks : {true, false}) {
    static_cast<g2o::LinearSolverCCS<g2o::MatrixX>&>(linear).setBlockOrdering(by_blocks);
    ASSERT_TRUE(linear.solve(A, x.data(), b.data()));
    Eigen::Matrix4d dense = Eigen::Matrix4d::Zero();
    for (int c = 0; c < 2; ++c)
      for (int r = 0; r <= c; ++r) dense.block<2, 2>(2 * r, 2 * c) = *A.block(r, c);
    dense = Eigen::Matrix4d(dense.selfadjointView<Eigen::Upper>());
    EXPECT_LT((dense * x - b_before).norm(), 1e-13);
    Matrix inverse;
    ASSERT_TRUE(linear.solvePattern(inverse, {{0, 1}, {1, 1}}, A));
    EXPECT_LT((*inverse.block(0, 1) - dense.inverse().block<2, 2>(0, 2)).norm(), 1e-14);
    EXPECT_LT((*inverse.block(1, 1) - dense.inverse().block<2, 2>(2, 2)).norm(), 1e-14);
    double** blocks = nullptr;
    ASSERT_TRUE(linear.solveBlocks(blocks, A));
    EXPECT_NEAR(blocks[0][2], dense.inverse()(0, 1), 1e-14);
    linear.deallocateBlocks(A, blocks);
  }
  (*A.block(1, 1))(1, 1) = -6;
  // g2o's LinearSolverCholmod solves indefinite systems (LDLᵀ), so the engine behind this name does it, too.
  EXPECT_EQ(linear.solve(A, x.data(), b.data()), std::string(GetParam()) == "_cholmod");
}

INSTANTIATE_TEST_SUITE_P(Engine, NamedSolver, testing::Values("_cholmod", "_csparse"),
                         [](const auto& test) { return std::string(test.param).substr(1); });
INSTANTIATE_TEST_SUITE_P(OptIn, NamedSolver, testing::Values("_suitesparse_cholmod", "_suitesparse_csparse"),
                         [](const auto& test) { return std::string(test.param).substr(1); });

TEST(Algorithms, NamedAfterCholmodAndCSparseHaveTheSolverOfTheEngine) {
  const auto kind_of = [](const char* name) {
    const auto algorithm = construct(name);
    auto& solver = static_cast<g2o::OptimizationAlgorithmWithHessian&>(*algorithm).solver();
    return static_cast<g2o::BlockSolverX&>(solver).linearSolver().engine().solver;
  };
  EXPECT_EQ(kind_of("lm_var_cholmod"), g2o::internal::EngineSolver::kCholesky);
  EXPECT_EQ(kind_of("lm_var_csparse"), g2o::internal::EngineSolver::kCholesky);
}

TEST(LinearStart, FindsTheMinimumFromArbitraryEstimates) {
  double expected = 0;
  for (const std::string name : {"gn_var", "2dlinear"}) {
    SCOPED_TRACE(name);
    g2o::SparseOptimizer optimizer;
    add_square(optimizer);
    optimizer.setAlgorithm(construct(name));
    if (name == "2dlinear") {
      for (int i = 1; i < 4; ++i)
        static_cast<g2o::VertexSE2*>(optimizer.vertex(i))->setEstimate(g2o::SE2(7 * i, -9, 2.5 * i));
    }
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_EQ(optimizer.optimize(8), 8);
    optimizer.computeActiveErrors();
    if (name == "gn_var") expected = optimizer.activeChi2();
    EXPECT_NEAR(optimizer.activeChi2(), expected, 1e-9 * expected);
  }
}

TEST(LinearStart, RefusesUnsupportedGraphsWithAMessage) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  for (const bool point : {false, true}) {
    g2o::SparseOptimizer optimizer;
    point ? add_square_with_point(optimizer) : add_square(optimizer);
    if (!point) optimizer.vertex(0)->setFixed(false);
    optimizer.setAlgorithm(construct("2dlinear"));
    ASSERT_TRUE(optimizer.initializeOptimization());
    EXPECT_EQ(optimizer.optimize(1), 0);
    EXPECT_THAT(messages.back(), testing::HasSubstr(point ? "EDGE_SE2" : "needs a path from a fixed vertex"));
  }
  g2o::logging::setSink({});
}

}  // namespace
