// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/robot_laser.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Three beams to the right, ahead and to the left. The laser is 0.5 m in front of the center of the robot,
/// which looks along y.
constexpr const char* kFields =
    "2 -1.5707963267948966 3.141592653589793 1.5707963267948966 10 0.01 1 3 1 10 4 2 0.25 7 "
    "2 3.5 1.5707963267948966 2 3 1.5707963267948966 0.5 -0.1 0.3 0.2 1e9 1234567890.125 robot-7 0.75";

RobotLaser read(std::string_view fields) {
  FieldReader in("g", 4, fields);
  return RobotLaser::read(in);
}

std::string complaint(std::string_view fields) {
  try {
    read(fields);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(RobotLaser, HasTheFieldsOfTheLineInTheirOrder) {
  const RobotLaser scan = read(kFields);
  EXPECT_EQ(scan.type, 2);
  EXPECT_EQ(scan.first_beam, -std::numbers::pi / 2);
  EXPECT_EQ(scan.field_of_view, std::numbers::pi);
  EXPECT_EQ(scan.angular_step, std::numbers::pi / 2);
  EXPECT_EQ(scan.max_range, 10);
  EXPECT_EQ(scan.accuracy, 0.01);
  EXPECT_EQ(scan.remission_mode, 1);
  EXPECT_THAT(scan.ranges, ElementsAre(1, 10, 4));
  EXPECT_THAT(scan.remissions, ElementsAre(0.25, 7));
  EXPECT_THAT(scan.laser_pose, ElementsAre(2, 3.5, std::numbers::pi / 2));
  EXPECT_THAT(scan.robot_pose, ElementsAre(2, 3, std::numbers::pi / 2));
  EXPECT_EQ(scan.translational_velocity, 0.5);
  EXPECT_EQ(scan.rotational_velocity, -0.1);
  EXPECT_EQ(scan.forward_safety_distance, 0.3);
  EXPECT_EQ(scan.side_safety_distance, 0.2);
  EXPECT_EQ(scan.turn_axis, 1e9);
  EXPECT_EQ(scan.stamp.timestamp, 1234567890.125);
  EXPECT_EQ(scan.stamp.host, "robot-7");
  EXPECT_EQ(scan.stamp.logger_timestamp, 0.75);
}

TEST(RobotLaser, IsWrittenAsItWasRead) {
  std::string text;
  FieldWriter out(text);
  read(kFields).write(out);
  FieldReader in("g", 1, text);
  std::string again;
  FieldWriter out_again(again);
  RobotLaser::read(in).write(out_again);
  EXPECT_EQ(again, text);
  EXPECT_THAT(text, HasSubstr("10 0.01 1 3 1 10 4 2 0.25 7 2 3.5 1.5707963267948966 2 3 1.5707963267948966"));
}

TEST(RobotLaser, GivesThePointsThatItHasHitInTheFrameOfTheRobot) {
  const RobotLaser scan = read(kFields);
  EXPECT_NEAR(scan.T_robot_laser().x(), 0.5, 1e-15);
  EXPECT_NEAR(scan.T_robot_laser().y(), 0, 1e-15);
  const auto points = scan.end_points_of_robot();
  ASSERT_EQ(points.size(), 2) << "the second range is the largest one";
  EXPECT_NEAR((points[0] - Vector<double, 2>(0.5, -1)).norm(), 0, 1e-14);
  EXPECT_NEAR((points[1] - Vector<double, 2>(0.5, 4)).norm(), 0, 1e-14);
  EXPECT_NEAR((scan.end_points()[1] - Vector<double, 2>(0, 4)).norm(), 0, 1e-14);
}

TEST(RobotLaser, HasNoPointsForRangesThatAreNotPositive) {
  RobotLaser scan;
  scan.max_range = 5;
  scan.ranges = {0, -1, std::numeric_limits<double>::quiet_NaN(), 5, 4.5};
  EXPECT_EQ(scan.end_points().size(), 1);
}

TEST(RobotLaser, ReportsTheFieldThatIsWrong) {
  EXPECT_EQ(complaint("2 0 1"), "g:4:6: expected the angle between beams, got the end of the line");
  EXPECT_EQ(complaint("x"), "g:4:1: expected the type of a laser (an integer), got 'x'");
  EXPECT_EQ(complaint("0 0 1 1 10 0 0 2 1 nan"), "g:4:20: expected a range (a finite number), got 'nan'");
  EXPECT_EQ(complaint("0 0 1 1 10 0 0 -1"), "g:4:16: expected the number of ranges (a number ≥ 0), got -1");
  EXPECT_EQ(complaint("0 0 1 1 10 0 0 1.5"), "g:4:16: expected the number of ranges (an integer), got '1.5'");
  EXPECT_EQ(complaint(std::string(kFields) + " 8"),
            "g:4:" + std::to_string(std::string_view(kFields).size() + 2) +
                ": expected the end of the line, got '8'");
}

TEST(RobotLaser, NeedsNoMemoryForRangesThatTheLineDoesNotHave) {
  EXPECT_EQ(complaint("0 0 1 1 10 0 0 9000000000000000000 1"),
            "g:4:37: expected a range, got the end of the line");
}

TEST(RobotLaser, IsNotWrittenIfItCouldNotBeRead) {
  std::string text;
  FieldWriter out(text);
  RobotLaser scan;
  scan.stamp.host = "two words";
  EXPECT_THROW(scan.write(out), InvalidArgument);
  scan.stamp.host = "";
  EXPECT_THROW(scan.write(out), InvalidArgument);
  scan.stamp.host = "host";
  scan.ranges = {std::numeric_limits<double>::infinity()};
  EXPECT_THROW(scan.write(out), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
