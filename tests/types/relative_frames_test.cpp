// SPDX-License-Identifier: BSD-3-Clause
// The relative frames of edges agree with their errors: an error is zero if `to` = `from` · motion.
#include <gmock/gmock.h>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

detail::Frame compose(const detail::Frame& a, const detail::Frame& b) {
  const int d = b.dimension;
  detail::Frame c = b;
  for (int i = 0; i < d; ++i) {
    c.translation[i] = a.translation[i];
    for (int k = 0; k < d; ++k) c.translation[i] += a.rotation[i * d + k] * b.translation[k];
    for (int j = 0; j < d; ++j) {
      c.rotation[i * d + j] = 0;
      for (int k = 0; k < d; ++k) c.rotation[i * d + j] += a.rotation[i * d + k] * b.rotation[k * d + j];
    }
  }
  return c;
}

/// The norm of the error after `to` was set to the frame that relative_frame() predicts.
template <class E, class From, class To, class... Rest>
double error_at_guess(const E& edge, const From& from, To to, const Rest&... rest) {
  const detail::RelativeFrame relative = edge.relative_frame(from, to, rest...);
  EXPECT_EQ(relative.from, 0);
  EXPECT_EQ(relative.to, 1);
  detail::FrameTrait<To>::set(to, compose(detail::FrameTrait<From>::get(from), relative.motion));
  return edge.error(from, to, rest...).norm();
}

template <class E, class To, class... Rest>
double error_at_absolute_guess(const E& edge, To to, const Rest&... rest) {
  const detail::RelativeFrame relative = edge.relative_frame(to, rest...);
  EXPECT_EQ(relative.from, detail::RelativeFrame::kWorld);
  EXPECT_EQ(relative.to, 0);
  detail::Frame frame = detail::FrameTrait<To>::get(to);
  frame.translation = relative.motion.translation;
  if (relative.motion.has_rotation) frame.rotation = relative.motion.rotation;
  detail::FrameTrait<To>::set(to, frame);
  return edge.error(to, rest...).norm();
}

const SE2 kX(1, 2, 0.5), kY(-2, 0.3, 2.9), kP(0.2, 0.1, -0.7);
const SE3 kX3 = pose(1, 2, 3, 0.3, -0.4, 0.9), kY3 = pose(0, 1, 0, 0.4, 0, 0),
          kP3 = pose(0, 0.1, 0.2, 1, 1, 1);
constexpr double kTiny = 1e-13;

TEST(RelativeFrames, InThePlaneMakeTheErrorZero) {
  EXPECT_LT(error_at_guess(Between(SE2(1, 2, 3)), kX, kY), kTiny);
  EXPECT_LT(error_at_guess(OffsetBetween<SE2>(SE2(1, 2, 3)), kX, kY, kP, kX), kTiny);
  EXPECT_LT(error_at_guess(OffsetBetween<SE2>(SE2(1, 2, 3)), kX, kY, kP), kTiny);
  EXPECT_LT(error_at_guess(PointObservation2(Vector2(1, 2)), kX, Vector2(0, 0)), kTiny);
  EXPECT_LT(error_at_guess(OffsetPointObservation2(Vector2(1, 2)), kX, Vector2(0, 0), kP), kTiny);
  EXPECT_LT(error_at_guess(WheelOdometry({1, 2, 0.5}), kX, kY, DifferentialDrive{1.1, 0.9, 0.4}), kTiny);
  EXPECT_LT(error_at_absolute_guess(Prior(kY), kX), kTiny);
  EXPECT_LT(error_at_absolute_guess(PositionPrior(Vector2(1, 2)), kX), kTiny);
}

TEST(RelativeFrames, InSpaceMakeTheErrorZero) {
  EXPECT_LT(error_at_guess(Between(kY3), kX3, SE3()), kTiny);
  EXPECT_LT(error_at_guess(OffsetBetween<SE3>(kY3), kX3, SE3(), kP3, kX3), kTiny);
  EXPECT_LT(error_at_guess(PointObservation3(Vector3(1, 2, 3)), kX3, Vector3(0, 0, 0)), kTiny);
  EXPECT_LT(error_at_guess(OffsetPointObservation3(Vector3(1, 2, 3)), kX3, Vector3(0, 0, 0), kP3), kTiny);
  EXPECT_LT(error_at_absolute_guess(Prior(kY3), kX3), kTiny);
  EXPECT_LT(error_at_absolute_guess(OffsetPrior<SE3>(kY3), kX3, kP3), kTiny);
  EXPECT_LT(error_at_absolute_guess(PositionPrior(Vector3(1, 2, 3)), kX3, kP3), kTiny);
}

TEST(RelativeFrames, ContainTheUnitAndTheRowsOfTheRotation) {
  EXPECT_EQ(Between(SE3()).relative_frame(SE3(), SE3()).rotation_unit, 0.5);
  EXPECT_EQ(Between(SE3()).relative_frame(SE3(), SE3()).rotation_row, 3);
  EXPECT_EQ(Between(SE2()).relative_frame(SE2(), SE2()).rotation_unit, 1);
  EXPECT_EQ(Between(SE2()).relative_frame(SE2(), SE2()).rotation_rows, 1);
  const SE3RotationVector x;
  EXPECT_EQ(Between(x).relative_frame(x, x).rotation_unit, 1);
}

}  // namespace
}  // namespace boxplus
