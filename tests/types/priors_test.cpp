// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE2 kX(1, 2, 0.5);
const SE3 kX3 = pose(1, 2, 3, 0.3, -0.4, 0.9), kP3 = pose(0, 0.1, 0.2, 1, 1, 1);

TEST(Prior, OfAPoseHasAnErrorInTheFrameOfTheMeasurement) {
  const Vector3 e = Prior(SE2(1, 0, kPi / 2)).error(SE2(1, 2, kPi));
  EXPECT_NEAR(e[0], 2, 1e-15);
  EXPECT_NEAR(e[1], 0, 1e-15);
  EXPECT_NEAR(e[2], kPi / 2, 1e-15);
}

TEST(Prior, OfAPointHasTheDifferenceAsItsError) {
  EXPECT_EQ(Prior(Vector2(1, 2)).error(Vector2(3, 5)), Vector2(2, 3));
}

TEST(Prior, HasCorrectJacobians) {
  expect_correct_jacobians(Prior(SE2(0.2, 0.1, 2)), kX);
  expect_correct_jacobians(Prior(kP3), kX3);
  expect_correct_jacobians(Prior(Vector3(1, 2, 3)), Vector3(3, 1, 2));
  expect_correct_jacobians(OffsetPrior<SE3>(pose(0, 1, 0, 0.2, 0.1, 0)), kX3, kP3);
  expect_correct_jacobians(PositionPrior(Vector2(3, 4)), kX);
  expect_correct_jacobians(PositionPrior(Vector3(3, 4, 5)), kX3);
  expect_correct_jacobians(PositionPrior(Vector3(3, 4, 5)), kX3, kP3);
}

TEST(OffsetPrior, MeasuresThePoseOfTheSensor) {
  EXPECT_LT(OffsetPrior<SE3>(kX3 * kP3).error(kX3, kP3).norm(), 1e-14);
}

TEST(PositionPrior, DoesNotDependOnTheHeading) {
  EXPECT_EQ(PositionPrior(Vector2(0, 0)).error(SE2(1, 2, 0.1)),
            PositionPrior(Vector2(0, 0)).error(SE2(1, 2, 3)));
}

}  // namespace
}  // namespace boxplus
