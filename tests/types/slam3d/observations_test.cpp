// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE3 kX = pose(1, 2, 3, 0.3, -0.4, 0.9), kP = pose(0, 0.1, 0.2, 1, 1, 1);
const Vector3 kL(3, -1, 2), kM(-2, 4, 1);

TEST(Observations3, HaveCorrectJacobians) {
  expect_correct_jacobians(PointObservation3(Vector3(1, 2, 3)), kX, kL);
  expect_correct_jacobians(OffsetPointObservation3(Vector3(1, 2, 3)), kX, kL, kP);
  expect_correct_jacobians(BearingObservation3(Vector3(1, 2, 3)), kX, kL);
  expect_correct_jacobians(Range(2), kX, kL);
  expect_correct_jacobians(PointsObservation3(Vector<double, 6>::Ones()), kX, std::vector<Vector3>{kL, kM});
}

TEST(Observations3, OfPointsHaveAnalyticJacobians) {
  EXPECT_TRUE((detail::kAnalytic<PointObservation3, SE3, Vector3>));
  EXPECT_TRUE((detail::kAnalytic<OffsetPointObservation3, SE3, Vector3, SE3>));
}

TEST(Observations3, WorkWithBothChartsOfPoses) {
  const SE3RotationVector x(kX.translation(), kX.quaternion());
  EXPECT_EQ(PointObservation3(Vector3(1, 2, 3)).error(x, kL),
            PointObservation3(Vector3(1, 2, 3)).error(kX, kL));
  expect_correct_jacobians(PointObservation3(Vector3(1, 2, 3)), x, kL);
}

TEST(OffsetPointObservation3, AppliesTheOffset) {
  EXPECT_LT(OffsetPointObservation3((kX * kP).inverse() * kL).error(kX, kL, kP).norm(), 1e-14);
}

TEST(OffsetPointObservation3, TakesItsOffsetFromAParameterOfTheGraph) {
  Graph graph;
  const auto x = graph.add_vertex(kX);
  const auto l = graph.add_vertex(kL);
  const auto p = graph.add_parameter(kP);
  const auto edge = graph.add_edge(OffsetPointObservation3((kX * kP).inverse() * kL), 4.0, x, l, p);
  EXPECT_LT(graph.chi2(edge), 1e-26);
  EXPECT_TRUE(graph.is_fixed(p));
}

TEST(BearingObservation3, NormalizesItsDirectionAndIgnoresTheDistance) {
  const BearingObservation3 edge(Vector3(0, 0, 5));
  EXPECT_LT(edge.error(SE3(), Vector3(0, 0, 7)).norm(), 1e-15);
  EXPECT_NEAR(edge.error(SE3(), Vector3(0.01, 0, 1)).norm(), 0.01, 1e-6);
}

}  // namespace
}  // namespace boxplus
