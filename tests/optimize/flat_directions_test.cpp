// SPDX-License-Identifier: BSD-3-Clause
// Runs that start where Jacobians are zero.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/types/range.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

/// Gauss-Newton fails at such estimates, and names the vertex.
class FlatDirections : public ::testing::TestWithParam<AlgorithmKind> {
 protected:
  Options options_{.algorithm = GetParam()};
};

TEST_P(FlatDirections, AreLeftIfADistanceIsMeasuredBetweenPositionsThatCoincide) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2());
  const auto point = graph.add_vertex(Vector2(0, 0));
  graph.fix(pose);
  graph.add_edge(Range(2), pose, point);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.chi2_initial, 4);
  EXPECT_LT(report.chi2_final, 1e-12) << report;
  EXPECT_NEAR(graph.estimate(point).norm(), 2, 1e-6);
  EXPECT_EQ(report.displaced_directions, 2);
  EXPECT_THAT(to_string(report), testing::HasSubstr("displaced 2 directions in which chi2 was stationary"));
}

TEST_P(FlatDirections, AreLeftIfTwoMovingPointsCoincide) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(0, 0));
  graph.add_edge(Range(2), a, b);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_NEAR((graph.estimate(a) - graph.estimate(b)).norm(), 2, 1e-6);
}

TEST_P(FlatDirections, AreLeftIfARotationIsWrongBy180Degrees) {
  for (const SE3::Quaternion& wrong :
       {SE3::Quaternion{1, 0, 0, 0}, SE3::Quaternion{0, 1, 0, 0}, SE3::Quaternion{0, 0, 1, 0}}) {
    Graph graph;
    const auto first = graph.add_vertex(SE3());
    const auto second = graph.add_vertex(SE3(Vector3(1, 0, 0), wrong));
    graph.fix(first);
    graph.add_edge(Between(SE3(Vector3(1, 0, 0), SE3::Quaternion::identity())), first, second);
    const Report report = optimize(graph, options_);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-12) << report;
    EXPECT_EQ(report.displaced_directions, 1);
  }
}

TEST_P(FlatDirections, AreLeftBesideVerticesThatMove) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  const auto point = graph.add_vertex(Vector2(0, 0));
  graph.set_estimate(point, Vector2(graph.estimate(poses[0]).x(), graph.estimate(poses[0]).y()));
  graph.fix(poses[0]);
  graph.add_edge(Range(2), poses[0], point);
  Graph without;
  without.fix(add_noisy_circle(without, 20)[0]);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_NEAR(report.chi2_final, optimize(without, options_).chi2_final, 1e-6);
}

TEST_P(FlatDirections, KeepTheirEstimatesIfNothingMeasuresThem) {
  Graph graph;
  const auto point = graph.add_vertex(Vector3(0, 0, 7));
  graph.add_edge([](const auto& p) { return p[0] - 3.0; }, point);
  graph.add_edge([](const auto& p) { return p[0] + p[1] * p[1] - 5.0; }, point);
  const Report report = optimize(graph, options_);
  EXPECT_NEAR(graph.estimate(point)[2], 7, 1e-12) << report;
  EXPECT_EQ(report.displaced_directions, 1);
  EXPECT_LT(report.chi2_final, 1e-12);
}

TEST_P(FlatDirections, AreNotDisplacedAtAMinimum) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(3, 0));
  graph.add_edge([](const auto& p) { return p[0] - 2.0 + 3.0 * p[1] * p[1]; }, point);
  graph.add_edge([](const auto& p) { return p[0] - 4.0 + p[1] * p[1]; }, point);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.displaced_directions, 0);
  EXPECT_EQ(graph.estimate(point)[1], 0);
  EXPECT_NEAR(report.chi2_final, 2, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, FlatDirections,
                         ::testing::Values(AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kDogleg),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace boxplus
