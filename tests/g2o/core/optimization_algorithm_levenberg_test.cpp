// SPDX-License-Identifier: BSD-3-Clause
// Tests when Levenberg-Marquardt stops.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

namespace {

/// An action that records the chi2 of its optimizer.
class Chi2Record : public g2o::HyperGraphAction {
 public:
  explicit Chi2Record(const g2o::SparseOptimizer& optimizer) : optimizer_(&optimizer) {}
  HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    chi2.push_back(optimizer_->activeRobustChi2());
    return this;
  }
  std::vector<double> chi2;

 private:
  const g2o::SparseOptimizer* optimizer_;
};

/// The minimum chi2 of the graph that add_contradiction() builds.
constexpr double kMinimum = 2.26455873132957;

/// Adds a square whose diagonals contradict its sides, so that its minimum chi2 is far from zero.
void add_contradiction(g2o::SparseOptimizer& optimizer) {
  small_graph::add_square(optimizer);
  for (int k = 1; k <= 3; ++k) small_graph::add_motion(optimizer, 0, 2, g2o::SE2(1 + 0.5 * k, 0.2, 2.5));
}

TEST(Levenberg, StopsWhenChi2ChangesOnlyByRoundingErrors) {
  g2o::SparseOptimizer optimizer;
  add_contradiction(optimizer);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(small_graph::make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  Chi2Record record(optimizer);
  ASSERT_TRUE(optimizer.addPostIterationAction(&record));
  const int done = optimizer.optimize(512);
  ASSERT_EQ(record.chi2.size(), static_cast<size_t>(done));
  EXPECT_GT(done, 5);
  int below_rounding = 0;
  for (size_t i = 1; i < record.chi2.size(); ++i)
    below_rounding += std::abs(record.chi2[i - 1] - record.chi2[i]) < 1e-13 * record.chi2[i];
  EXPECT_LE(below_rounding, 1) << "of " << done << " iterations";
  EXPECT_LT(record.chi2.back(), kMinimum * (1 + 1e-12));
}

TEST(Levenberg, PrintsNoErrorIfDampingMakesUpForAMissingGauge) {
  g2o::SparseOptimizer optimizer;
  add_contradiction(optimizer);
  optimizer.vertex(0)->setFixed(false);
  auto* algorithm = new g2o::OptimizationAlgorithmLevenberg(small_graph::make_solver());
  algorithm->setUserLambdaInit(1e-30);
  algorithm->setMaxTrialsAfterFailure(20);
  optimizer.setAlgorithm(algorithm);
  ASSERT_TRUE(optimizer.initializeOptimization());
  int warnings = 0, errors = 0;
  g2o::logging::setSink([&](g2o::logging::Level level, const std::string&) {
    ++(level == g2o::logging::Level::kError ? errors : warnings);
  });
  EXPECT_GT(optimizer.optimize(30), 0);
  g2o::logging::setSink({});
  EXPECT_GT(warnings, 0) << "the first λ is too small";
  EXPECT_EQ(errors, 0);
  optimizer.computeActiveErrors();
  EXPECT_LT(optimizer.activeRobustChi2(), kMinimum * (1 + 1e-9));
}

TEST(Levenberg, ContinuesWhenStepsAreShortBecauseLambdaIsLarge) {
  g2o::SparseOptimizer optimizer;
  add_contradiction(optimizer);
  auto* algorithm = new g2o::OptimizationAlgorithmLevenberg(small_graph::make_solver());
  algorithm->setUserLambdaInit(1e15);
  optimizer.setAlgorithm(algorithm);
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(512), 30) << "lambda decreases only by a factor of three per iteration";
  optimizer.computeActiveErrors();
  EXPECT_LT(optimizer.activeChi2(), kMinimum * (1 + 1e-12));
}

}  // namespace
