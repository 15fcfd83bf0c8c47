// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/macros.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

TEST(Macros, WriteValuesWithTheirNamesAndNumbersInFixedNotation) {
  std::ostringstream out;
  const double half_turn = 3.14159265358979323846;
  out << PVAR(2 * 3) << "; " << PVARA(half_turn) << "; " << FIXED(0.5) << "; " << 0.5;
  EXPECT_EQ(out.str(), "2 * 3 = 6; half_turn = 180deg; 0.500000; 0.5");
}

}  // namespace
