// SPDX-License-Identifier: BSD-3-Clause
// Macros of another library, such as PCL, whose header comes first.
#define DEG2RAD(x) ((x)*1000)
#define RAD2DEG(x) ((x)*2000)
#define FIXED(s) "fixed " << (s)

#include "g2o/stuff/macros.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

TEST(Macros, WriteValuesWithTheirNames) {
  std::ostringstream out;
  const double half_turn = 3.14159265358979323846;
  out << PVAR(2 * 3) << "; " << PVARA(half_turn);
  EXPECT_EQ(out.str(), "2 * 3 = 6; half_turn = 180deg");
}

TEST(Macros, DoNotReplaceMacrosOfTheSameNamesFromOtherLibraries) {
  std::ostringstream out;
  out << FIXED(0.5) << "; " << DEG2RAD(1) << "; " << RAD2DEG(1);
  EXPECT_EQ(out.str(), "fixed 0.5; 1000; 2000");
}

}  // namespace
