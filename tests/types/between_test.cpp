// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/between.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/so2.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE2 kA(1, 2, 0.5), kB(-2, 0.3, 2.9), kZ(0.7, -1.1, -2.5);
const SE3 kA3 = pose(1, 2, 3, 0.3, -0.4, 0.9), kB3 = pose(-1, 0.5, 2, 1.2, 0.3, -2.0),
          kZ3 = pose(0.2, 0.1, -0.7, 0, 0.8, 0.1);

TEST(Between, IsZeroIfTheMotionEqualsTheMeasurement) {
  EXPECT_LT(Between(kA.inverse() * kB).error(kA, kB).norm(), 1e-14);
  EXPECT_LT(Between(kA3.inverse() * kB3).error(kA3, kB3).norm(), 1e-14);
  EXPECT_LT(Between(Vector2(1, -1)).error(Vector2(2, 2), Vector2(3, 1)).norm(), 1e-14);
}

TEST(Between, IsExpressedInTheFrameOfTheMeasurementForPosesInThePlane) {
  const Vector3 e = Between(SE2(1, 0, kPi / 2)).error(SE2(0, 0, 0), SE2(1, 2, kPi / 2 + 0.25));
  EXPECT_NEAR(e[0], 2, 1e-15);
  EXPECT_NEAR(e[1], 0, 1e-15);
  EXPECT_NEAR(e[2], 0.25, 1e-15);
}

TEST(Between, ContainsTheVectorPartOfAQuaternionForPosesInSpace) {
  const auto e = Between(SE3()).error(SE3(), pose(1, 2, 3, 0, 0, 0.2));
  EXPECT_NEAR(e[5], std::sin(0.1), 1e-15);
  EXPECT_DOUBLE_EQ(e[2], 3);
}

TEST(Between, UsesTheQuaternionWithPositiveWForPosesInSpace) {
  const SE3 turned = pose(0, 0, 0, 0, 0, 3.5);  // w = cos 1.75 < 0
  ASSERT_LT(turned.quaternion().w, 0);
  EXPECT_NEAR(Between(SE3()).error(SE3(), turned)[5], -std::sin(1.75), 1e-15);
}

TEST(Between, HasCorrectJacobians) {
  expect_correct_jacobians(Between(kZ), kA, kB);
  expect_correct_jacobians(Between(kZ3), kA3, kB3);
  expect_correct_jacobians(Between(kZ3), kB3, kA3);
  expect_correct_jacobians(Between(SE3()), SE3(), pose(0.1, 0, 0, 0, 0, 3.5));
  expect_correct_jacobians(Between(Vector3(1, 2, 3)), Vector3(0, 1, 0), Vector3(2, 2, 2));
  expect_correct_jacobians(Between(SO2(1)), SO2(0.2), SO2(2));
  expect_correct_jacobians(Between(SE3RotationVector(Vector3(1, 0, 0), kZ3.quaternion())),
                           SE3RotationVector(Vector3(1, 2, 3), kA3.quaternion()),
                           SE3RotationVector(Vector3(0, 2, 1), kB3.quaternion()));
}

TEST(Between, IsDifferentiatedAnalyticallyForPoses) {
  EXPECT_TRUE((detail::kAnalytic<Between<SE2>, SE2, SE2>));
  EXPECT_TRUE((detail::kAnalytic<Between<SE3>, SE3, SE3>));
  EXPECT_FALSE((detail::kAnalytic<Between<Vector2>, Vector2, Vector2>));
}

TEST(Between, IsNamedAfterItsType) {
  EXPECT_EQ(detail::type_name<Between<SE2>>(), "Between<SE2>");
  EXPECT_EQ(detail::type_name<Between<SE3RotationVector>>(), "Between<SE3RotationVector>");
  EXPECT_EQ(detail::type_name<Between<Vector2>>(), "Between<Vector2>");
}

TEST(OffsetBetween, MeasuresTheMotionFromOneSensorToTheOther) {
  const SE2 p(0.5, 0, 0.1), q(0, -1, 2);
  const OffsetBetween<SE2> edge((kA * p).inverse() * (kB * q));
  EXPECT_LT(edge.error(kA, kB, p, q).norm(), 1e-14);
  expect_correct_jacobians(OffsetBetween<SE2>(kZ), kA, kB, p, q);
  expect_correct_jacobians(OffsetBetween<SE2>(kZ), kA, kB, p);
  expect_correct_jacobians(OffsetBetween<SE3>(kZ3), kA3, kB3, pose(1, 0, 0, 0, 1, 0),
                           pose(0, 1, 0, 0.3, 0, 0));
}

TEST(OffsetBetween, AcceptsTheSameSensorAtBothEnds) {
  const SE2 p(0.5, 0, 0.1);
  EXPECT_EQ(OffsetBetween<SE2>(kZ).error(kA, kB, p), OffsetBetween<SE2>(kZ).error(kA, kB, p, p));
}

TEST(Between, CanBeAddedToAGraph) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0)), b = graph.add_vertex(SE2(0.9, 0.1, 0));
  const auto edge = graph.add_edge(Between(SE2(1, 0, 0)), 100.0, a, b);
  EXPECT_NEAR(graph.chi2(edge), 100 * 0.02, 1e-13);
  EXPECT_EQ(graph.edge_pools()[0]->jacobian_source(), detail::JacobianSource::kAnalytic);
}

TEST(Between, AcceptsEigenVectorsAndBoxplusVectors) {
  static_assert(std::is_same_v<decltype(Between(Eigen::Vector2d(1, 2))), Between<Vector2>>);
  static_assert(std::is_same_v<decltype(Prior(Eigen::Vector3d(1, 2, 3))), Prior<Vector3>>);
  static_assert(std::is_same_v<decltype(PositionPrior(Eigen::Vector2d(1, 2))), PositionPrior<Vector2>>);
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Eigen::Vector2d(4, 6));
  EXPECT_EQ(graph.chi2(graph.add_edge(Between(Eigen::Vector2d(1, 2)), a, b)), 25);
}

}  // namespace
}  // namespace boxplus
