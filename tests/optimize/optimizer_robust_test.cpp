// SPDX-License-Identifier: BSD-3-Clause
// Runs with robust kernels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"

namespace boxplus {
namespace {

/// The range from a point in the plane to a beacon.
struct Range {
  Vector2 beacon;
  double meters;
  template <class S>
  Vector<S, 1> error(const Vector<S, 2>& point) const {
    return Vector<S, 1>((point - beacon).norm() - S(meters));
  }
};

/// A point, and ranges to beacons around it. A third of the ranges is wrong by several standard deviations.
Graph point_among_beacons(const Huber& kernel) {
  Graph graph;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto point = graph.add_vertex(Vector2(8, -5));
  for (int k = 0; k < 60; ++k) {
    const Vector2 beacon(20 * std::cos(0.1 * k), 20 * std::sin(0.1 * k));
    const double wrong = k % 3 == 0 ? 3 + 2 * std::abs(normal(random)) : 0;
    const auto edge = graph.add_edge(Range{beacon, beacon.norm() + 0.5 * normal(random) + wrong}, point);
    graph.set_kernel(edge, kernel);
  }
  return graph;
}

Report run(AlgorithmKind algorithm, bool triggs_correction) {
  Graph graph = point_among_beacons(Huber(0.5));
  return optimize(graph, {.algorithm = algorithm,
                          .cost_tolerance = 1e-16,
                          .noise_tolerance = 0,
                          .triggs_correction = triggs_correction});
}

/// The number of iterations until the gradient is a billionth of the first one.
std::ptrdiff_t iterations_until_flat(const Report& report) {
  const double limit = 1e-9 * report.records.front().gradient_max;
  const auto flat = std::ranges::find_if(
      report.records, [&](const IterationRecord& record) { return record.gradient_max <= limit; });
  return flat - report.records.begin();
}

TEST(RobustRuns, ConvergeFasterThanLinearlyWithTheCorrectionOfTriggs) {
  for (const auto algorithm : {AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg}) {
    const Report with = run(algorithm, true), without = run(algorithm, false);
    EXPECT_TRUE(with.converged()) << with.message;
    EXPECT_LE(iterations_until_flat(with), 14);
    EXPECT_GT(iterations_until_flat(without), 16);
  }
}

TEST(RobustRuns, EndAtTheSameMinimumWithAndWithoutTheCorrectionOfTriggs) {
  Graph corrected = point_among_beacons(Huber(0.5)), alone = point_among_beacons(Huber(0.5));
  const Report with = optimize(corrected, {.triggs_correction = true});
  const Report without = optimize(alone, {.algorithm = AlgorithmKind::kGaussNewton});
  EXPECT_TRUE(with.converged() && without.converged());
  EXPECT_NEAR(with.chi2_final, without.chi2_final, 1e-8 * without.chi2_final);
}

}  // namespace
}  // namespace boxplus
