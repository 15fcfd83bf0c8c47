// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/types/slam2d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE2 kX(1, 2, 0.5), kP(0.2, 0.1, -0.7);
const Vector2 kL(3, -1), kM(-2, 4);

TEST(PointObservation2, MeasuresInTheFrameOfThePose) {
  const Vector2 e = PointObservation2(Vector2(1, 0)).error(SE2(1, 1, kPi / 2), Vector2(1, 3));
  EXPECT_NEAR(e[0], 1, 1e-15);
  EXPECT_NEAR(e[1], 0, 1e-15);
}

TEST(PointObservation2, AcceptsPlainEigenVectorsAsPoints) {
  Graph graph;
  const auto x = graph.add_vertex(kX);
  const auto l = graph.add_vertex(Eigen::Vector2d(3, -1));
  const auto edge = graph.add_edge(PointObservation2(Vector2(0, 0)), x, l);
  EXPECT_NEAR(graph.chi2(edge), 13, 1e-13);
}

TEST(OffsetPointObservation2, AppliesTheOffset) {
  const OffsetPointObservation2 edge((kX * kP).inverse() * kL);
  EXPECT_LT(edge.error(kX, kL, kP).norm(), 1e-14);
  EXPECT_GT(edge.error(kX, kL, SE2()).norm(), 0.1);
}

TEST(Observations2, HaveCorrectJacobians) {
  expect_correct_jacobians(PointObservation2(Vector2(1, 2)), kX, kL);
  expect_correct_jacobians(OffsetPointObservation2(Vector2(1, 2)), kX, kL, kP);
  expect_correct_jacobians(BearingObservation2(2), kX, kL);
  expect_correct_jacobians(Range(2), kX, kL);
  expect_correct_jacobians(Range(2), kX, kP);
  expect_correct_jacobians(TwoPointsObservation2(Vector<double, 4>(1, 2, 3, 4)), kX, kL, kM);
  expect_correct_jacobians(PointsObservation2(Eigen::Vector4d(1, 2, 3, 4)), kX, std::vector<Vector2>{kL, kM});
}

TEST(Observations2, OfPointsHaveAnalyticJacobians) {
  EXPECT_TRUE((detail::kAnalytic<PointObservation2, SE2, Vector2>));
  EXPECT_TRUE((detail::kAnalytic<OffsetPointObservation2, SE2, Vector2, SE2>));
}

TEST(BearingObservation2, HasAnErrorBetweenMinusPiAndPi) {
  EXPECT_NEAR(BearingObservation2(3).error(SE2(), Vector2(-1, -0.1)), 3 - (std::atan2(-0.1, -1) + 2 * kPi),
              1e-14);
}

TEST(Range, IsTheDistanceMinusTheMeasurement) {
  EXPECT_DOUBLE_EQ(Range(3).error(SE2(1, 1, 2), Vector2(4, 5)), 2);
}

TEST(PointsObservation2, AgreesWithObservationsOfSinglePoints) {
  const PointsObservation2 both(Eigen::Vector4d(1, 2, 3, 4));
  const std::vector<Vector2> points{kL, kM};
  const auto e = both.error(kX, std::span<const Vector2>(points));
  EXPECT_EQ(e.head<2>(), PointObservation2(Vector2(1, 2)).error(kX, kL));
  EXPECT_EQ(e.tail<2>(), PointObservation2(Vector2(3, 4)).error(kX, kM));
}

TEST(PointsObservation2, RefusesANumberOfPointsThatDiffersFromItsMeasurement) {
  Graph graph;
  const auto x = graph.add_vertex(kX);
  const std::vector points{graph.add_vertex(kL)};
  EXPECT_THROW(graph.add_edge(PointsObservation2(Eigen::Vector4d(1, 2, 3, 4)), x, points), InvalidArgument);
  EXPECT_EQ(graph.edge_count(), 0u);
}

}  // namespace
}  // namespace boxplus
