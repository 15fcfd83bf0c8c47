// SPDX-License-Identifier: BSD-3-Clause
// How the damping of Levenberg-Marquardt changes from step to step.
#include "optimize/levenberg_marquardt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus {
namespace {

/// The lowest and the highest factor by which the damping changed.
struct Factors {
  double lowest = 1e300, highest = 0;
  int count = 0;
  void add(double factor) {
    lowest = std::min(lowest, factor);
    highest = std::max(highest, factor);
    ++count;
  }
};

TEST(LevenbergMarquardt, LowersTheDampingToAThirdAfterAGoodStepAndLessAfterARejectedOne) {
  Factors good, good_after_rejection, poor;
  for (const BundleShape shape : {BundleShape::kStreet, BundleShape::kCity}) {
    Graph graph =
        simulate_bundle(shape, {.cameras = 30, .points = 1000, .pose_noise = 3, .point_noise = 10}).graph;
    const Report report = optimize(graph, {.algorithm = AlgorithmKind::kLevenbergMarquardt});
    for (std::size_t k = 0; k + 1 < report.records.size(); ++k) {
      const IterationRecord &step = report.records[k], &next = report.records[k + 1];
      if (next.tries > 1) continue;  // rejected steps have raised the damping
      const double gain = step.chi2_decrease / step.predicted_decrease, factor = next.lambda / step.lambda;
      if (gain <= 0.5) {
        poor.add(factor);
      } else {
        (step.tries == 1 ? good : good_after_rejection).add(factor);
      }
    }
  }
  ASSERT_GT(good.count, 0);
  EXPECT_NEAR(good.lowest, 1.0 / 3, 1e-12);
  EXPECT_NEAR(good.highest, 1.0 / 3, 1e-12);
  ASSERT_GT(good_after_rejection.count, 0);
  EXPECT_GE(good_after_rejection.lowest, 2.0 / 3 - 1e-12);
  EXPECT_LE(good_after_rejection.highest, 1);
  ASSERT_GT(poor.count, 0);
  EXPECT_GE(poor.lowest, 1);
  EXPECT_LE(poor.highest, 2);
}

TEST(LevenbergMarquardt, FollowsAPointThatIsAlmostAtInfinity) {
  // A step of Gauss-Newton doubles the distance, which decreases chi2 by three quarters of what it predicts.
  Graph graph;
  const auto distance = graph.add_vertex(1.0);
  const auto inverse = [](const auto& d) { return Vector<std::decay_t<decltype(d)>, 1>(1 / d - 1e-4); };
  graph.add_edge(inverse, 1e10, distance);
  const Report report =
      optimize(graph, {.algorithm = AlgorithmKind::kLevenbergMarquardt, .max_iterations = 1000});
  EXPECT_TRUE(report.converged());
  EXPECT_NEAR(graph.estimate(distance), 1e4, 1e-3);
  EXPECT_LE(report.iterations, 25);
}

}  // namespace
}  // namespace boxplus
