// SPDX-License-Identifier: BSD-3-Clause
// Which algorithms bear a factor in float.
#include <gtest/gtest.h>

#include "boxplus/optimize/optimize.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

Report two_iterations(Graph& graph, AlgorithmKind algorithm, Precision precision = Precision::kAutomatic) {
  graph.push();
  Report report = optimize(graph, {.algorithm = algorithm, .precision = precision, .max_iterations = 2});
  graph.pop();
  return report;
}

/// Large enough for float to pay.
Graph large_sphere() {
  return simulate(World::kSphere, {.poses = 2500}).graph;
}

TEST(TheAutomaticPrecision, IsDoubleForGaussNewtonAndFloatForAlgorithmsThatJudgeTheirSteps) {
  Graph graph = large_sphere();
  for (const AlgorithmKind algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    const Report report = two_iterations(graph, algorithm);
    EXPECT_EQ(report.linear.precision, Precision::kMixed);
    EXPECT_GT(report.records.back().linear_iterations, 0);
  }
  const Report report = two_iterations(graph, AlgorithmKind::kGaussNewton);
  EXPECT_EQ(report.linear.precision, Precision::kDouble);
  EXPECT_EQ(report.records.back().linear_iterations, 0);
  EXPECT_FALSE(report.plan_reused);
}

TEST(TheAutomaticPrecision, OfAnotherAlgorithmDoesNotDependOnWhatRanBefore) {
  Graph graph = large_sphere();
  const double chi2 = two_iterations(graph, AlgorithmKind::kDogleg).chi2_final;
  two_iterations(graph, AlgorithmKind::kGaussNewton);
  EXPECT_EQ(two_iterations(graph, AlgorithmKind::kDogleg).chi2_final, chi2);
}

TEST(APrecisionByName, HoldsForGaussNewtonToo) {
  Graph graph = large_sphere();
  const Report report = two_iterations(graph, AlgorithmKind::kGaussNewton, Precision::kMixed);
  EXPECT_EQ(report.linear.precision, Precision::kMixed);
}

}  // namespace
}  // namespace boxplus
