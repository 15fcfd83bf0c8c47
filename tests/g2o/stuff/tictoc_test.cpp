// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/tictoc.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace {

TEST(TicToc, MeasuresNamedPartsIfTheEnvironmentVariableIsSet) {
  setenv("G2O_ENABLE_TICTOC", "1", 1);
  EXPECT_EQ(g2o::tictoc("sleep"), -1);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_GE(g2o::tictoc("sleep"), 0.002);
  { const g2o::ScopeTicToc scope("scope"); }
  EXPECT_THAT(g2o::tictocReport(),
              testing::AllOf(testing::HasSubstr("sleep\tnumber= 1"), testing::HasSubstr("scope\tnumber= 1")));
}

}  // namespace
