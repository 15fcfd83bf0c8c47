// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/depth_image.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/so2.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

using MountedCamera = Product<SE3, PinholeCamera>;

const SE3 kPose = pose(1, 2, 3, 0, 0, kPi / 2);
const Vector3 kPoint(0, 4, 7);  // (2, 1, 4) in the frame of kPose
// One meter behind the robot's origin, so the point is at (2, 1, 5).
const MountedCamera kCamera(pose(0, 0, -1, 0, 0, 0), PinholeCamera(100, 200, 30, 40));

TEST(DepthImage, IsThePixelAndTheDepth) {
  // 100 · 2/5 + 30 = 70, 200 · 1/5 + 40 = 80.
  EXPECT_LT((DepthImage(Vector3(1, 2, 3)).error(kPose, kPoint, kCamera) - Vector3(69, 78, 2)).norm(), 1e-12);
}

TEST(DisparityImage, IsThePixelAndTheInverseDepth) {
  EXPECT_LT((DisparityImage(Vector3(1, 2, 0.1)).error(kPose, kPoint, kCamera) - Vector3(69, 78, 0.1)).norm(),
            1e-12);
}

TEST(DepthImages, HaveCorrectJacobians) {
  const SE3 turned = pose(1, 2, 3, 0.3, -0.4, 0.5);
  const MountedCamera camera(pose(0.1, -0.2, 0.3, 0.2, 0.1, -0.3), PinholeCamera(100, 200, 30, 40));
  expect_correct_jacobians(DepthImage(Vector3(1, 2, 3)), turned, kPoint, camera);
  expect_correct_jacobians(DisparityImage(Vector3(1, 2, 3)), turned, kPoint, camera);
}

}  // namespace
}  // namespace boxplus
