// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/initial_guess/nearest_rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace boxplus::guess {
namespace {

SmallMatrix plane_rotation(double angle) {
  SmallMatrix r(2, 2);
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

TEST(NearestRotation, KeepsARotationAndUndoesItsScale) {
  const SmallMatrix r = plane_rotation(2.5);
  EXPECT_LT((*nearest_rotation(r) - r).norm(), 1e-15);
  EXPECT_LT((*nearest_rotation(1e-8 * r) - r).norm(), 1e-15);
}

TEST(NearestRotation, TurnsAReflectionIntoTheClosestProperRotation) {
  SmallMatrix m = SmallMatrix::Identity(3, 3);
  m(2, 2) = -0.5;
  EXPECT_LT((*nearest_rotation(m) - SmallMatrix::Identity(3, 3)).norm(), 1e-15);
}

TEST(NearestRotation, CompletesTwoDirectionsOfSpace) {
  SmallMatrix m = SmallMatrix::Identity(3, 3);
  m(2, 2) = 0;
  EXPECT_LT((*nearest_rotation(m) - SmallMatrix::Identity(3, 3)).norm(), 1e-15);
}

TEST(NearestRotation, IsEmptyWhereTheRotationIsNotUnique) {
  EXPECT_FALSE(nearest_rotation(SmallMatrix::Zero(3, 3)));
  EXPECT_FALSE(nearest_rotation(SmallMatrix::Zero(2, 2)));
  SmallMatrix mirror = SmallMatrix::Identity(2, 2);
  mirror(1, 1) = -1;
  EXPECT_FALSE(nearest_rotation(mirror));
  SmallMatrix line = SmallMatrix::Zero(3, 3);
  line(0, 0) = 1;
  EXPECT_FALSE(nearest_rotation(line));
  EXPECT_FALSE(nearest_rotation(SmallMatrix::Constant(2, 2, std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace boxplus::guess
