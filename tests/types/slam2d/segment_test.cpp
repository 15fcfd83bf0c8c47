// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d/segment.h"

#include <gmock/gmock.h>

#include "boxplus/testing/check_manifold.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE2 kPose(1, 2, kPi / 2);
/// In the frame of kPose, it goes from (2, 0) to (2, 3).
const Segment2 kSegment{Vector2(1, 4), Vector2(-2, 4)};

TEST(Segment2, IsAManifold) {
  const ManifoldCheck check = check_manifold<Segment2>({kSegment, Segment2{}});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(SegmentObservation2, MeasuresBothEndsInTheFrameOfThePose) {
  const Vector<double, 4> e = SegmentObservation2(Vector<double, 4>(2, 0, 2, 2)).error(kPose, kSegment);
  EXPECT_LT((e - Vector<double, 4>(0, 0, 0, 1)).norm(), 1e-14);
}

TEST(SegmentLineObservation2, MeasuresTheNormalAndTheDistance) {
  const Vector2 e = SegmentLineObservation2(Vector2(0.25, 1.5)).error(kPose, kSegment);
  EXPECT_NEAR(e[0], -0.25, 1e-14);  // the normal points along x
  EXPECT_NEAR(e[1], 0.5, 1e-14);
}

TEST(SegmentEndObservation2, MeasuresOneEndAndTheNormal) {
  const Vector3 first = SegmentEndObservation2(Vector3(2, 1, 0), false).error(kPose, kSegment);
  EXPECT_LT((first - Vector3(0, -1, 0)).norm(), 1e-14);
  const Vector3 second = SegmentEndObservation2(Vector3(2, 1, kPi), true).error(kPose, kSegment);
  EXPECT_LT((second - Vector3(0, 2, kPi)).norm(), 1e-14);
}

TEST(SegmentObservations2, HaveCorrectJacobians) {
  expect_correct_jacobians(SegmentObservation2(Vector<double, 4>(1, 2, 3, 4)), kPose, kSegment);
  expect_correct_jacobians(SegmentLineObservation2(Vector2(1, 2)), kPose, kSegment);
  expect_correct_jacobians(SegmentEndObservation2(Vector3(1, 2, 3), false), kPose, kSegment);
  expect_correct_jacobians(SegmentEndObservation2(Vector3(1, 2, 3), true), kPose, kSegment);
}

}  // namespace
}  // namespace boxplus
