// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "boxplus/incremental/smoother.h"
#include "boxplus/types/slam2d.h"
#include "incremental/drive.h"

namespace boxplus {
namespace {

TEST(Smoother, HoldsTheFirstVertexUntilSomethingAnchorsTheGraph) {
  Drive drive(2);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 20; ++k) drive.step();
  SmootherReport report = smoother.update();
  ASSERT_EQ(report.held.size(), 1u);
  EXPECT_EQ(report.held[0].vertex, drive.poses()[0]);
  drive.graph.add_edge(Prior(SE2(5, 6, 0.7)), 1e6, drive.poses()[7]);
  report = smoother.finish();
  EXPECT_TRUE(report.held.empty());
  EXPECT_NEAR(drive.graph.estimate(drive.poses()[7]).translation()[0], 5, 1e-3);
  EXPECT_LT(distance_from_batch(drive.graph), 1e-6);
}

TEST(Smoother, HoldsAVertexOfEachPartIfTheGraphIsCutApartAndReleasesItWhenItIsJoined) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  std::vector<EdgeHandle<Between<SE2>>> edges;
  for (int k = 1; k < 400; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0.01 * k, 0)));
    edges.push_back(
        graph.add_edge(Between(SE2(1, 0.001, 0.002)), 100.0, poses[poses.size() - 2], poses.back()));
  }
  Smoother smoother(graph);
  EXPECT_EQ(smoother.update().held.size(), 1u);
  graph.remove(edges[200]);
  SmootherReport report = smoother.finish();
  EXPECT_TRUE(report.converged()) << report.message;
  EXPECT_EQ(report.held.size(), 2u);
  EXPECT_LT(distance_from_batch(graph), 1e-6);
  graph.add_edge(Between(SE2(1, 0, 0.1)), 100.0, poses[200], poses[201]);
  report = smoother.finish();
  EXPECT_EQ(report.held.size(), 1u);
  EXPECT_LT(distance_from_batch(graph), 1e-6);
}

TEST(Smoother, TreatsADisabledEdgeAsIfItWereNotThere) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  std::vector<EdgeHandle<Between<SE2>>> edges;
  for (int k = 1; k < 6; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0.1, 0)));
    edges.push_back(graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[poses.size() - 2], poses.back()));
  }
  graph.set_enabled(edges[2], false);
  graph.set_enabled(edges[4], false);
  Smoother smoother(graph);
  SmootherReport report = smoother.update();
  EXPECT_TRUE(report.converged()) << report.message;
  EXPECT_EQ(report.held.size(), 2U);
  EXPECT_EQ(report.edges, 3U);
  EXPECT_EQ(graph.estimate(poses[5]).translation()[1], 0.1);  // it takes no part
  graph.set_enabled(edges[2], true);
  graph.set_enabled(edges[4], true);
  report = smoother.finish();
  EXPECT_EQ(report.held.size(), 1U);
  EXPECT_EQ(report.edges, 5U);
  EXPECT_LT(distance_from_batch(graph), 1e-6);
  graph.set_enabled(edges[2], false);
  EXPECT_EQ(smoother.update().held.size(), 2U);
}

TEST(Smoother, HasNoPreviewOfAnEdgeThatMayMoveAWholePart) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (const double x : {0, 1, 9, 10}) poses.push_back(graph.add_vertex(SE2(x, x > 5 ? 9 : 0, 0)));
  graph.fix(poses[0]);
  graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[0], poses[1]);
  graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[2], poses[3]);
  Smoother smoother(graph);
  EXPECT_EQ(smoother.update().held.size(), 1U);
  const auto joins = graph.add_edge(Between(SE2(4, 0, 0)), 100.0, poses[1], poses[3]);
  const auto places = graph.add_edge(Prior(SE2(4, 0, 0)), 100.0, poses[3]);
  const auto within = graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[2], poses[3]);
  for (const EdgeRef edge : {EdgeRef(joins), EdgeRef(places), EdgeRef(within)})
    graph.set_enabled(edge, false);
  EXPECT_THROW(static_cast<void>(smoother.preview(joins)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(smoother.preview(places)), InvalidArgument);
  EXPECT_NEAR(smoother.preview(within).chi2_increase, 0, 1e-9);
  graph.set_enabled(joins, true);
  EXPECT_TRUE(smoother.finish().converged());
  EXPECT_NEAR(graph.chi2(), 0, 1e-9);
}

TEST(Smoother, LeavesAVertexOutAsLongAsItsEdgesDoNotDetermineIt) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2());
  graph.fix(pose);
  const auto point = graph.add_vertex(Vector2(1, 2)), other = graph.add_vertex(Vector2(3, 4));
  graph.add_edge(PointObservation2(Vector2(1, 2.5)), 1.0, pose, point);
  const auto weightless = graph.add_edge(PointObservation2(Vector2(0, 0)), 0.0, pose, other);
  Smoother smoother(graph);
  const SmootherReport report = smoother.update();
  EXPECT_TRUE(report.converged());
  ASSERT_EQ(report.held.size(), 1U);
  EXPECT_EQ(report.held[0].vertex, other);
  EXPECT_NEAR(graph.estimate(point)[1], 2.5, 1e-9);
  EXPECT_EQ(graph.estimate(other), Vector2(3, 4));
  graph.set_information(weightless, 1.0);
  EXPECT_TRUE(smoother.update().held.empty());
  EXPECT_NEAR(graph.estimate(other)[1], 0, 1e-9);
}

/// The distance to a landmark.
struct Range {
  double measured;
  template <class S>
  Vector<S, 1> error(const BasicSE2<S>& pose, const Vector<S, 2>& landmark) const {
    using std::sqrt;
    const Vector<S, 2> d = landmark - pose.translation();
    return Vector<S, 1>(sqrt(d[0] * d[0] + d[1] * d[1]) - measured);
  }
};

TEST(Smoother, DrivesOnWithLandmarksOfASingleRange) {
  Graph graph;
  Smoother smoother(graph);
  const Vector2 truths[] = {{2, 3}, {4, -2}, {6, 3}};
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  graph.fix(poses[0]);
  std::vector<VertexHandle<Vector2>> landmarks;
  for (const Vector2& truth : truths)
    landmarks.push_back(graph.add_vertex(Vector2(truth + Vector2(0.3, 0.2))));
  for (int k = 1; k <= 6; ++k) {
    const SE2 truth(k, k % 2, 0);
    poses.push_back(graph.add_vertex(SE2(k + 0.1, k % 2 - 0.1, 0.01)));
    graph.add_edge(Between(SE2(k - 1, (k - 1) % 2, 0).inverse() * truth), 100.0, poses[poses.size() - 2],
                   poses.back());
    for (std::size_t l = 0; l < landmarks.size(); ++l)
      graph.add_edge(Range{(truths[l] - truth.translation()).norm()}, 10.0, poses.back(), landmarks[l]);
    const SmootherReport report = smoother.update();
    EXPECT_TRUE(report.converged()) << report.message;
    EXPECT_EQ(report.held.size() + report.held_directions, k == 1 ? 3U : 0U) << "step " << k;
    EXPECT_NEAR(graph.estimate(poses.back()).translation()[0], k, 0.02);
  }
  smoother.finish();
  for (std::size_t l = 0; l < landmarks.size(); ++l)
    EXPECT_LT((graph.estimate(landmarks[l]) - truths[l]).norm(), 1e-6);
}

TEST(Smoother, TakesAVertexInWhenItIsFixed) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2(1, 0, 0));
  const auto point = graph.add_vertex(Vector2(3, 0));
  graph.fix(a);
  graph.add_edge(Between(SE2(1, 0, 0)), 1.0, a, b);
  graph.add_edge(Range{1}, 100.0, b, point);
  Smoother smoother(graph);
  EXPECT_EQ(smoother.update().held.size() + smoother.update().held_directions, 1U);
  graph.fix(point);
  EXPECT_TRUE(smoother.finish().held.empty());
  Graph copy = graph;
  EXPECT_NEAR(graph.chi2(), optimize(copy).chi2_final, 1e-9);
}

TEST(Smoother, TakesLandmarksInWhoseRangesCameBeforeTheOdometry) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 4; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
  const auto point = graph.add_vertex(Vector2(1.5, 2.5));
  graph.fix(poses[0]);
  const auto range = [&](int k) { return Range{std::hypot(1.0 - k, 2.0)}; };
  graph.add_edge(Between(SE2(1, 0, 0)), 1.0, poses[0], poses[1]);
  for (const int k : {1, 2, 3}) graph.add_edge(range(k), 1.0, poses[static_cast<std::size_t>(k)], point);
  Smoother smoother(graph);
  EXPECT_TRUE(smoother.update().converged());
  for (const std::size_t k : {2U, 3U}) {
    graph.add_edge(Between(SE2(1, 0, 0)), 1.0, poses[k - 1], poses[k]);
    EXPECT_TRUE(smoother.update().converged());
  }
  const SmootherReport report = smoother.finish();
  EXPECT_EQ(report.held.size() + report.held_directions, 0U);
  EXPECT_NEAR(graph.chi2(), 0, 1e-9);
  EXPECT_LT((graph.estimate(point) - Vector2(1, 2)).norm(), 1e-4);
}

TEST(Smoother, HoldsOneVertexOfTwoAndMovesTheOther) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2());
  const auto point = graph.add_vertex(Vector2(3, 4));
  graph.add_edge(PointObservation2(Vector2(5, 5)), 1.0, pose, point);
  Smoother smoother(graph);
  EXPECT_EQ(smoother.finish().held.size(), 1U);
  EXPECT_NEAR(graph.chi2(), 0, 1e-12);
  EXPECT_NO_THROW((void)smoother.covariance({point}));
}

TEST(Smoother, KeepsAFixedLagFreeOfLandmarksWithASingleRange) {
  Graph graph;
  Smoother smoother(graph, {.lag = 10});
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  graph.fix(poses[0]);
  for (int k = 1; k <= 60; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[poses.size() - 2], poses.back());
    graph.add_edge(Range{2}, 10.0, poses.back(), graph.add_vertex(Vector2(k, 2)));
    EXPECT_TRUE(smoother.update().converged());
  }
  EXPECT_LE(graph.vertex_count(), 25U);
}

TEST(Smoother, HoldsADirectionThatNothingDetermines) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(1, 2));
  graph.add_edge([](const Vector2& x) { return x[0] + x[1] - 1; }, 1.0, point);
  Smoother smoother(graph);
  const SmootherReport report = smoother.update();
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.held_directions, 1u);
  const Eigen::MatrixXd covariance = smoother.covariance({point});
  EXPECT_EQ((covariance.array() != 0).count(), 1);
  EXPECT_NEAR(graph.estimate(point)[0] + graph.estimate(point)[1], 1, 1e-9);
}

TEST(Smoother, ReleasesAHeldVertexIfANewVertexJoinsTwoParts) {
  Graph graph;
  Smoother smoother(graph);
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2(1, 0, 0));
  const auto c = graph.add_vertex(SE2(5, 0, 0)), d = graph.add_vertex(SE2(6, 0, 0));
  const Between one(SE2(1, 0, 0));
  graph.add_edge(one, 1.0, a, b);
  graph.add_edge(one, 1.0, c, d);
  EXPECT_EQ(smoother.update().held.size(), 2u);
  const auto middle = graph.add_vertex(SE2(3, 0, 0));
  graph.add_edge(Between(SE2(1, 1, 0)), 1.0, b, middle);
  graph.add_edge(Between(SE2(5, 0, 0)), 1.0, middle, d);
  EXPECT_EQ(smoother.finish().held.size(), 1u);
  EXPECT_NEAR(graph.chi2(), 0, 1e-12);
}

TEST(Smoother, DoesNotCallAChainUndeterminedOrPlanItAgainHoweverLongItIs) {
  Graph graph;
  Smoother smoother(graph);
  auto last = graph.add_vertex(SE2());
  SmootherReport report;
  for (int k = 1; k < 7000; ++k) {
    const auto next = graph.add_vertex(SE2(k, 0, 0));
    graph.add_edge(Between(SE2(1, 0, 0)), 1.0, last, next);
    last = next;
    report = smoother.update();
    ASSERT_TRUE(report.converged()) << k;
  }
  EXPECT_EQ(report.held.size(), 1u);
  EXPECT_LE(report.refactored, 2u);
}

}  // namespace
}  // namespace boxplus
