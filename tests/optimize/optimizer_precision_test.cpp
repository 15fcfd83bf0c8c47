// SPDX-License-Identifier: BSD-3-Clause
// Which algorithms use a Cholesky factor in single precision.
#include <gtest/gtest.h>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

/// A graph that is so large that single precision is faster, and its Optimizer.
struct LargeSphere {
  Graph graph = simulate(World::kSphere, {.poses = 2500}).graph;
  Optimizer optimizer{graph};

  Report two_iterations(AlgorithmKind algorithm, Precision precision = Precision::kAutomatic) {
    optimizer.set_options({.algorithm = algorithm, .precision = precision, .max_iterations = 2});
    graph.push();
    Report report = optimizer.run();
    graph.pop();
    return report;
  }
};

TEST(AutomaticPrecision, IsDoubleForGaussNewtonAndMixedForDoglegAndLevenbergMarquardt) {
  LargeSphere sphere;
  for (const AlgorithmKind algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    const Report report = sphere.two_iterations(algorithm);
    EXPECT_EQ(report.linear.precision, Precision::kMixed);
    EXPECT_GT(report.records.back().linear_iterations, 0);
  }
  const Report report = sphere.two_iterations(AlgorithmKind::kGaussNewton);
  EXPECT_EQ(report.linear.precision, Precision::kDouble);
  EXPECT_EQ(report.records.back().linear_iterations, 0);
  EXPECT_FALSE(report.plan_reused);
}

TEST(AutomaticPrecision, DoesNotDependOnTheAlgorithmThatRanBefore) {
  LargeSphere sphere;
  const double chi2 = sphere.two_iterations(AlgorithmKind::kDogleg).chi2_final;
  EXPECT_EQ(sphere.two_iterations(AlgorithmKind::kGaussNewton).iterations, 2);
  EXPECT_EQ(sphere.two_iterations(AlgorithmKind::kDogleg).chi2_final, chi2);
}

TEST(ChosenPrecision, AppliesToGaussNewtonToo) {
  LargeSphere sphere;
  const Report report = sphere.two_iterations(AlgorithmKind::kGaussNewton, Precision::kMixed);
  EXPECT_EQ(report.linear.precision, Precision::kMixed);
}

}  // namespace
}  // namespace boxplus
