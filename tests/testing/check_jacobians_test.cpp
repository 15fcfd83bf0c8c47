// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/check_jacobians.h"

#include <gmock/gmock.h>

#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A point observation. One entry of its Jacobian with respect to the point is wrong.
struct WrongPointObservation : PointObservation2 {
  using PointObservation2::PointObservation2;
  template <class A, class B>
  void jacobians(const SE2& pose, const Vector2& point, A& J_pose, B& J_point) const {
    PointObservation2::jacobians(pose, point, J_pose, J_point);
    J_point(0, 1) += 1e-6;
  }
};

/// A point observation with a plain error function. Only numeric derivatives can detect its wrong entry.
struct WrongPlainObservation {
  Vector2 error(const SE2& pose, const Vector2& point) const { return pose.inverse_times(point); }
  template <class A, class B>
  void jacobians(const SE2& pose, const Vector2& point, A& J_pose, B& J_point) const {
    PointObservation2(Vector2(0, 0)).jacobians(pose, point, J_pose, J_point);
    J_pose(1, 2) *= -1;
  }
};

const SE2 kPose(0.3, -0.2, 0.7);
const Vector2 kPoint(1.5, 2.5);

TEST(CheckJacobians, CorrectAnalyticJacobiansPass) {
  const JacobianCheck check = check_jacobians(PointObservation2(Vector2(1, 2)), kPose, kPoint);
  EXPECT_TRUE(check.ok) << check.message;
  EXPECT_EQ(check.message, "");
}

TEST(CheckJacobians, AWrongEntryIsFoundAndReported) {
  const JacobianCheck check = check_jacobians(WrongPointObservation(Vector2(1, 2)), kPose, kPoint);
  EXPECT_FALSE(check.ok);
  EXPECT_THAT(check.message, HasSubstr("∂e/∂x_2 (Vector2), row 1, column 2: expected 0.644217687"));
  EXPECT_THAT(check.message, HasSubstr("analytic against exact"));
  EXPECT_THAT(check.message, Not(HasSubstr("x_1")));
}

TEST(CheckJacobians, AWrongEntryIsFoundWithoutDualNumbers) {
  const JacobianCheck check = check_jacobians(WrongPlainObservation{}, kPose, kPoint);
  EXPECT_FALSE(check.ok);
  EXPECT_THAT(check.message, HasSubstr("∂e/∂x_1 (SE2), row 2, column 3"));
  EXPECT_THAT(check.message, HasSubstr("analytic against numeric"));
}

TEST(CheckJacobians, ALambdaIsCheckedAgainstNumericDerivatives) {
  const auto distance = [](const auto& a, const auto& b) { return (b - a).norm(); };
  const JacobianCheck check = check_jacobians(distance, Vector2(0, 0), kPoint);
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(CheckJacobians, ARangeIsGivenAsAVectorOfEstimates) {
  const PointsObservation2 seen(Eigen::Vector4d(1, 2, 3, 4));
  const JacobianCheck check = check_jacobians(seen, kPose, std::vector<Vector2>{kPoint, -kPoint});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(CheckJacobians, ReportsWhichJacobiansOptimizeUses) {
  const auto source = [](const auto& edge, const auto&... x) {
    return to_string(check_jacobians(edge, x...).source);
  };
  EXPECT_EQ(source(PointObservation2(Vector2(1, 2)), kPose, kPoint), "analytic");
  EXPECT_EQ(source([](const auto& x) { return x[0] * x[1]; }, kPoint), "exact");
  EXPECT_EQ(source([](const Vector2& x) { return x[0] * x[1]; }, kPoint), "numeric");
}

TEST(CheckJacobians, AcceptsEigenVectorsLikeAGraph) {
  struct Plain {
    Eigen::Vector2d error(const SE2& pose, const Eigen::Vector2d& point) const {
      return pose.inverse_times(point);
    }
  };
  const JacobianCheck check = check_jacobians(Plain{}, kPose, Eigen::Vector2d(1.5, 2.5));
  EXPECT_TRUE(check.ok) << check.message;
  const PointsObservation2 seen(Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_TRUE(check_jacobians(seen, kPose, std::vector<Eigen::Vector2d>{kPoint, -kPoint}).ok);
}

TEST(CheckJacobians, AJacobianThatIsNotANumberFails) {
  const auto broken = [](const auto& x) { return x[0] / (x[0] - x[0]); };
  EXPECT_FALSE(check_jacobians(broken, kPoint).ok);
}

}  // namespace
}  // namespace boxplus
