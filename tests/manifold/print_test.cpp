// SPDX-License-Identifier: BSD-3-Clause
// operator<< of src/manifold/print.cpp.
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {
namespace {

template <class T>
std::string printed(const T& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

TEST(Print, ShowsTheNameAndTheValuesInTheOrderOfFiles) {
  const Vector<double, 3> t(1, 2, 3);
  const SE3::Quaternion q{0, 0, 0.6, 0.8};
  EXPECT_EQ(printed(SE2(1, 2, 0.5)), "SE2(1, 2, 0.5)");
  EXPECT_EQ(printed(SE3(t, q)), "SE3(1, 2, 3, 0, 0, 0.6, 0.8)");
  EXPECT_EQ(printed(SE3RotationVector(t, q)), "SE3RotationVector(1, 2, 3, 0, 0, 0.6, 0.8)");
  EXPECT_EQ(printed(SO2(0.5)), "SO2(0.5)");
  EXPECT_EQ(printed(SO3(q)), "SO3(0, 0, 0.6, 0.8)");
  EXPECT_EQ(printed(SO3RotationVector(q)), "SO3RotationVector(0, 0, 0.6, 0.8)");
  EXPECT_EQ(printed(S2()), "S2(0, 0, 1)");
  EXPECT_EQ(printed(Sim3(q, t, 2)), "Sim3(1, 2, 3, 0, 0, 0.6, 0.8, 2)");
}

TEST(Print, HasTheDigitsOfTheStream) {
  std::ostringstream out;
  out << std::setprecision(3) << SE2(1.23456, 2, 0);
  EXPECT_EQ(out.str(), "SE2(1.23, 2, 0)");
}

}  // namespace
}  // namespace boxplus
