// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/incremental/smoother.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "incremental/drive.h"

namespace boxplus {
namespace {

TEST(Smoother, IsAtTheOptimumAfterEachStep) {
  Drive drive(1);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 120; ++k) {
    drive.step();
    const SmootherReport report = smoother.update();
    ASSERT_TRUE(report.converged()) << report.message;
    ASSERT_LT(distance_from_batch(drive.graph), 0.01) << k;
  }
}

TEST(Smoother, FinishesAtTheSameEstimatesAsABatchAfterRandomEdits) {
  // BOXPLUS_SOAK is the number of drives, with some 200 edits each.
  const char* const soak = std::getenv("BOXPLUS_SOAK");
  const unsigned drives = soak != nullptr ? static_cast<unsigned>(std::atoi(soak)) : 8;
  for (unsigned seed = 1; seed <= drives; ++seed) {
    Drive drive(seed);
    if (seed % 2 == 0) drive.graph.fix(drive.poses()[0]);
    Smoother smoother(drive.graph);
    for (int k = 0; k < 100; ++k) {
      drive.step();
      for (std::size_t edits = drive.pick(5); edits-- > 0;) drive.edit();
      const SmootherReport report = k % 10 == 9 ? smoother.finish() : smoother.update();
      ASSERT_TRUE(report.converged())
          << to_string(report.reason) << report.message << ", seed " << seed << ", step " << k << " it "
          << report.iterations << " so " << report.started_over << " held " << report.held.size();
      if (k % 10 == 9) {
        // With robust kernels, the steps of both shrink slowly, so that a flat direction may end elsewhere.
        const double distance = distance_from_batch(drive.graph);
        ASSERT_TRUE(distance < 1e-6 || excess_over_batch(drive.graph) < 1e-9)
            << distance << ", seed " << seed << ", step " << k;
      }
    }
  }
}

TEST(Smoother, TouchesOnlyTheNewestPosesIfNoLoopIsClosed) {
  Graph graph;
  Smoother smoother(graph);
  auto last = graph.add_vertex(SE3());
  SmootherReport report;
  for (int k = 0; k < 300; ++k) {
    const auto next = graph.add_vertex(graph.estimate(last) * SE3(Eigen::Vector3d(1, 0, 0), SO3()));
    graph.add_edge(Between(SE3(Eigen::Vector3d(1, 0, 0), SO3())), 1.0, last, next);
    last = next;
    report = smoother.update();
  }
  EXPECT_EQ(report.vertices, 300u);
  EXPECT_LE(report.refactored, 2u);
  EXPECT_LE(report.ordered, 20u);
  EXPECT_LE(report.moved, 20u);
  EXPECT_EQ(report.held.size(), 1u);
}

TEST(Smoother, RemovesVerticesAndTakesVerticesThatReuseTheirSlots) {
  Drive drive(3);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 30; ++k) drive.step();
  smoother.update();
  Graph& graph = drive.graph;
  graph.remove(drive.poses().back());
  const auto before = drive.poses()[drive.poses().size() - 2];
  const auto fresh = graph.add_vertex(graph.estimate(before) * SE2(2, 0, 0));
  graph.add_edge(Between(SE2(2, 0.1, 0)), 1.0, before, fresh);
  EXPECT_TRUE(smoother.finish().converged());
  EXPECT_LT(distance_from_batch(graph), 1e-6);
}

TEST(Smoother, ReadsTheGraphAgainIfAnotherAlgorithmHasMovedIt) {
  Drive drive(6);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 30; ++k) drive.step();
  smoother.update();
  EXPECT_TRUE(optimize(drive.graph).converged());
  drive.graph.push();
  drive.step();
  smoother.update();
  drive.graph.pop();
  drive.step();
  EXPECT_TRUE(smoother.finish().converged());
  EXPECT_LT(distance_from_batch(drive.graph), 1e-6);
}

TEST(Smoother, FollowsAGraphThatIsCleared) {
  Drive drive(7);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 10; ++k) drive.step();
  smoother.update();
  drive.graph.clear();
  EXPECT_EQ(smoother.update().vertices, 0u);
  const auto a = drive.graph.add_vertex(SE2()), b = drive.graph.add_vertex(SE2());
  drive.graph.add_edge(Between(SE2(1, 0, 0)), 1.0, a, b);
  smoother.update();
  EXPECT_NEAR(drive.graph.estimate(b).translation()[0], 1, 1e-9);
}

}  // namespace
}  // namespace boxplus
