// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/inverse_depth.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/convert_to.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE3RotationVector kPose = convert_to<SE3RotationVector>(pose(1, 2, 3, 0.3, -0.4, 0.5));
const SE3RotationVector kAnchor = convert_to<SE3RotationVector>(pose(0, 1, 2, 0.2, 0.1, 0.3));
const StereoCamera kCamera{Vector<double, 4>(100, 30, 40, 0.2)};
const Vector3 kPoint(0.4, 0.8, 4);  // in the frame of the anchor
const Vector3 kPsi(0.1, 0.2, 0.25);

TEST(InverseDepthImage, IsTheImageOfThePointOfTheAnchor) {
  const Vector3 point = kAnchor * kPoint;
  const Vector2 expected = PointImage<2>(Vector2(1, 2)).error(point, kPose, kCamera);
  EXPECT_LT((InverseDepthImage(Vector2(1, 2)).error(kPsi, kPose, kAnchor, kCamera) - expected).norm(), 1e-12);
}

TEST(InverseDepthImage, IsTheDirectionInTheAnchorItself) {
  // 100 · 0.1 + 30, 100 · 0.2 + 40
  EXPECT_LT((InverseDepthImage(Vector2(1, 2)).error(kPsi, kPose, kPose, kCamera) - Vector2(39, 58)).norm(),
            1e-12);
}

TEST(InverseDepthImage, IsDefinedForPointsAtInfinity) {
  // In a camera with the rotation of the anchor, the position does not matter.
  const Vector3 shift = kAnchor.translation() + Vector3(5, 6, 7);
  const auto moved = SE3RotationVector::from_unit(shift, kAnchor.quaternion());
  const Vector2 e = InverseDepthImage(Vector2(1, 2)).error(Vector3(0.1, 0.2, 0), moved, kAnchor, kCamera);
  EXPECT_LT((e - Vector2(39, 58)).norm(), 1e-12);
}

TEST(InverseDepthImage, HasCorrectJacobians) {
  const InverseDepthImage edge(Vector2(10, 20));
  for (const double inverse_depth : {0.25, 0.0, -0.25})
    expect_correct_jacobians(edge, Vector3(0.1, 0.2, inverse_depth), kPose, kAnchor, kCamera);
  expect_correct_jacobians(edge, kPsi, convert_to<SE3>(kPose), convert_to<SE3>(kAnchor), kCamera);
}

}  // namespace
}  // namespace boxplus
