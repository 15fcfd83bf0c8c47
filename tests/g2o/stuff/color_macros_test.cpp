// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/color_macros.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

TEST(ColorMacros, WriteTheEscapeSequencesOfTerminals) {
  std::ostringstream out;
  out << CL_RED("stop" << 1) << CL_LIGHTBLUE(2) << CL_BLACK(3) << FG_GREEN << FT_BOLD << FG_NORM;
  EXPECT_EQ(out.str(), "\033[31mstop1\033[0m\033[34m2\033[0m\033[30m3\033[0m\033[32m\033[1m\033[0m");
}

}  // namespace
