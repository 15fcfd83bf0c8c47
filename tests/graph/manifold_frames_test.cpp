// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/manifold_frames.h"

#include <gtest/gtest.h>

#include <limits>

#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {
namespace {

TEST(ManifoldFrames, ReadAndWriteAPose) {
  constexpr double kTiny = 1e-13;
  const SE2 x(1, 2, 0.5);
  SE2 y;
  detail::FrameTrait<SE2>::set(y, detail::FrameTrait<SE2>::get(x));
  EXPECT_LT((y.vector() - x.vector()).norm(), kTiny);
  const SE3 x3(Vector3(1, 2, 3), SO3::from_rotation_vector(Vector3(0.3, -0.4, 0.9)).quaternion());
  SE3 y3;
  detail::FrameTrait<SE3>::set(y3, detail::FrameTrait<SE3>::get(x3));
  EXPECT_LT((y3.vector() - x3.vector()).norm(), kTiny);
  SE3RotationVector yr;
  detail::FrameTrait<SE3RotationVector>::set(yr, detail::FrameTrait<SE3>::get(x3));
  EXPECT_LT((yr.vector() - x3.vector()).norm(), kTiny);
}

TEST(ManifoldFrames, OfAPointHaveNoRotation) {
  const detail::Frame frame = detail::FrameTrait<Vector3>::get(Vector3(1, 2, 3));
  EXPECT_FALSE(frame.has_rotation);
  EXPECT_EQ(frame.dimension, 3);
  EXPECT_EQ(frame.translation[2], 3);
}

TEST(ManifoldFrames, CanReplaceAnEstimateThatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  SE3 pose =
      SE3::from_unit(Vector<double, 3>(kNan, kNan, kNan), detail::Quaternion<double>{kNan, kNan, kNan, kNan});
  detail::FrameTrait<SE3>::set(pose, detail::FrameTrait<SE3>::get(SE3()));
  EXPECT_EQ(pose.vector(), SE3().vector());
}

}  // namespace
}  // namespace boxplus
