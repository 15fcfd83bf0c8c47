// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/raw_laser.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using testing::ElementsAre;

TEST(RawLaser, HasTheFieldsOfTheLineInTheirOrder) {
  constexpr const char* kFields = "3 -0.5 1 0.25 8 0.1 2 3 1 8.5 2 1 0.5 100.25 host 0.125";
  FieldReader in("g", 1, kFields);
  const RawLaser laser = RawLaser::read(in);
  EXPECT_EQ(laser.type, 3);
  EXPECT_EQ(laser.angular_step, 0.25);
  EXPECT_THAT(laser.ranges, ElementsAre(1, 8.5, 2));
  EXPECT_THAT(laser.remissions, ElementsAre(0.5));
  EXPECT_EQ(laser.stamp.timestamp, 100.25);
  ASSERT_EQ(laser.end_points().size(), 2);
  EXPECT_NEAR((laser.end_points()[1] - Vector<double, 2>(2, 0)).norm(), 0, 1e-15) << "beam 2 looks ahead";
  std::string text;
  FieldWriter out(text);
  laser.write(out);
  EXPECT_EQ(text, kFields);
}

TEST(RawLaser, HasNoPoseOfARobot) {
  FieldReader in("g", 5, "3 -0.5 1 0.25 8 0.1 2 1 1 0 100 host 1 7");
  EXPECT_THROW(RawLaser::read(in), InputError);
}

}  // namespace
}  // namespace boxplus
