// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/tuple_tools.h"

#include <gtest/gtest.h>

namespace {

TEST(TupleTools, ApplyAFunctionToTheElementWithARunTimeIndex) {
  std::tuple<int, double> pair(1, 2.5);
  for (int i = 0; i < 3; ++i) g2o::tuple_apply_i([](auto& x) { x *= 2; }, pair, i);
  EXPECT_EQ(pair, std::make_tuple(2, 5.0));
}

}  // namespace
