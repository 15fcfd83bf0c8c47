// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/timeutil.h"

#include <gmock/gmock.h>

#include <ctime>

namespace {

void a_measured_function() {
  MEASURE_FUNCTION_TIME;
}

TEST(TimeUtil, RepeatsACommandByTheTimestampsOfTheCaller) {
  int runs = 0;
  for (double now : {10.0, 10.5, 11.0, 11.5, 3.0, 3.5}) DO_EVERY_TS(1, now, ++runs);
  EXPECT_EQ(runs, 3);  // at 10, at 11, and at 3, because the clock was set back
}

TEST(TimeUtil, PrintsTheTimeOfAFunction) {
  testing::internal::CaptureStderr();
  { const g2o::ScopeTime time("scope"); }
  MEASURE_TIME("code", EXPECT_TRUE(true));
  a_measured_function();
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::AllOf(testing::StartsWith("scope "), testing::HasSubstr(" ms\ncode "),
                             testing::HasSubstr("a_measured_function")));
}

TEST(TimeUtil, RepeatsACommandAfterItsInterval) {
  int often = 0, seldom = 0;
  for (int k = 0; k < 3; ++k) {
    DO_EVERY(0, ++often);
    DO_EVERY(3600, ++seldom);
  }
  EXPECT_EQ(often, 3);
  EXPECT_EQ(seldom, 1);
}

TEST(TimeUtil, FormatsATime) {
  std::tm noon{};
  noon.tm_year = 112;
  noon.tm_mon = 0;
  noon.tm_mday = 31;
  noon.tm_hour = 12;
  EXPECT_EQ(g2o::getTimeAsString(std::mktime(&noon)), "20120131_120000");
  EXPECT_EQ(g2o::getCurrentTimeAsString().size(), 15u);
}

}  // namespace
