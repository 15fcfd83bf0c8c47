// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "boxplus/incremental/smoother.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "incremental/drive.h"

namespace boxplus {
namespace {

TEST(Smoother, HasTheSameJointCovariancesAsABatch) {
  Drive drive(8);
  drive.graph.fix(drive.poses()[0]);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 60; ++k) {
    drive.step();
    smoother.update();
  }
  smoother.finish();
  const auto& poses = drive.poses();
  const std::vector<VertexRef> some{poses[7], poses.back(), poses[31]};
  const Eigen::MatrixXd joint = smoother.covariance(some);
  Optimizer batch(drive.graph);
  EXPECT_TRUE(batch.run().converged());
  const Covariance expected = batch.covariance(some);
  for (std::size_t a = 0; a < some.size(); ++a) {
    for (std::size_t b = 0; b < some.size(); ++b) {
      const auto i = static_cast<Eigen::Index>(3 * a), j = static_cast<Eigen::Index>(3 * b);
      EXPECT_LT((joint.block(i, j, 3, 3) - expected.of(some[a], some[b])).cwiseAbs().maxCoeff(),
                1e-6 * joint.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_TRUE(smoother.covariance({poses[0]}).isZero());
}

TEST(Smoother, PredictsWhatAnEdgeCostsAndChanges) {
  Drive drive(9);
  drive.graph.fix(drive.poses()[0]);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 40; ++k) drive.step();
  smoother.finish();
  Graph& graph = drive.graph;
  const auto a = drive.poses()[5], b = drive.poses()[25];
  const SE2 seen = graph.estimate(a).inverse() * graph.estimate(b) * SE2(0.05, -0.03, 0.01);
  const double before = graph.chi2();
  const auto edge = graph.add_edge(Between(seen), 2000.0, a, b);
  graph.set_enabled(edge, false);
  smoother.finish();
  const EdgePreview preview = smoother.preview(edge);
  EXPECT_NEAR(graph.chi2(), before, 1e-9 * before);
  const SE2 estimate = graph.estimate(b);
  graph.set_enabled(edge, true);
  smoother.finish();
  EXPECT_GT(preview.chi2, preview.chi2_increase);
  EXPECT_NEAR(graph.chi2() - before, preview.chi2_increase, 0.02 * preview.chi2_increase);
  const SE2 moved = estimate.inverse() * graph.estimate(b);
  EXPECT_NEAR(moved.translation()[0], preview.steps[1][0], 1e-3);
  EXPECT_NEAR(moved.translation()[1], preview.steps[1][1], 1e-3);
}

TEST(Smoother, HasCovariancesOnlyAfterASolutionAndOfVerticesThatTakePart) {
  Drive drive(2);
  drive.step();
  std::atomic<bool> stop = true;
  Smoother smoother(drive.graph, {.stop = &stop});
  EXPECT_THROW((void)smoother.covariance({drive.poses()[1]}), InvalidArgument);
  EXPECT_EQ(smoother.update().reason, SmootherReport::Reason::kStopFlag);
  EXPECT_THROW((void)smoother.covariance({drive.poses()[1]}), InvalidArgument);
  stop = false;
  EXPECT_TRUE(smoother.update().converged());
  EXPECT_NO_THROW((void)smoother.covariance({drive.poses()[1]}));
  EXPECT_THROW((void)smoother.covariance({drive.graph.add_vertex(SE2())}), InvalidArgument);
  EXPECT_THROW((void)smoother.covariance({drive.graph.add_vertex(Vector3(0, 0, 0))}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
