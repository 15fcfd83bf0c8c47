// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/surface_match.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const Vector3 kZ(0, 0, 1);

TEST(SurfaceMatch, IsTheOffsetOfTheSecondPointInTheFrameOfTheFirstPose) {
  const SurfaceMatch edge(Vector3(1, 2, 3), kZ, Vector3(0, 1, 0), kZ);
  // x₁ p₁ = (0, 0, 0) + (−1, 0, 0), which is (−2, 0, −1) from x₀. In the frame of x₀, it is (0, 2, −1).
  const Vector3 e = edge.error(pose(1, 0, 1, 0, 0, kPi / 2), pose(0, 0, 0, 0, 0, kPi / 2));
  EXPECT_LT((e - Vector3(-1, 0, -4)).norm(), 1e-14);
}

TEST(SurfaceMatch, HasInformationOneAlongTheNormalAndLittleAcross) {
  const Vector3 normal(0.6, 0, 0.8);
  const Matrix<double, 3, 3> omega = SurfaceMatch(kZ, normal, kZ, kZ).information();
  EXPECT_NEAR(normal.dot(omega * normal), 1, 1e-14);
  for (const Vector3& across : {Vector3(0, 1, 0), Vector3(-0.8, 0, 0.6)}) {
    EXPECT_NEAR(across.dot(omega * across), SurfaceMatch::kAcross, 1e-14);
    EXPECT_NEAR(across.dot(omega * normal), 0, 1e-14);
  }
}

TEST(FrameOfNormal, HasTheNormalAsItsLastRowAlsoIfTheNormalIsTheYAxis) {
  for (const Vector3& normal : {Vector3(0, 1, 0), Vector3(0, -1, 1e-9), Vector3(0.6, 0, 0.8)}) {
    const Matrix<double, 3, 3> F = detail::frame_of_normal(normal);
    EXPECT_LT((F * F.transpose() - Matrix<double, 3, 3>::Identity()).norm(), 1e-12);
    EXPECT_EQ(Vector3(F.row(2)), normal);
  }
}

TEST(SurfaceMatch, HasCorrectJacobians) {
  const SurfaceMatch edge(Vector3(1, 2, 3), kZ, Vector3(3, 1, 4), kZ);
  expect_correct_jacobians(edge, pose(1, 2, 3, 0.3, -0.4, 0.5), pose(0, 1, 2, 0.2, 0.1, 0.3));
}

}  // namespace
}  // namespace boxplus
