// SPDX-License-Identifier: BSD-3-Clause
#include "guess/nearest_rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace boxplus::guess {
namespace {

SmallMatrix plane_rotation(double angle) {
  SmallMatrix r(2, 2);
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

TEST(NearestRotation, OfAScaledRotationIsTheRotation) {
  const SmallMatrix r = plane_rotation(2.5);
  EXPECT_LT((*nearest_rotation(r) - r).norm(), 1e-15);
  EXPECT_LT((*nearest_rotation(1e-8 * r) - r).norm(), 1e-15);
}

TEST(NearestRotation, IsTheRotationInThePolarDecompositionOfRandomMatrices) {
  std::srand(1);
  for (int k = 0; k < 200; ++k) {
    const SmallMatrix m = SmallMatrix::Random(3, 3);
    const SmallMatrix r = *nearest_rotation(m), stretch = r.transpose() * m;
    EXPECT_LT((r.transpose() * r - SmallMatrix::Identity(3, 3)).norm(), 1e-14);
    EXPECT_NEAR(Eigen::Matrix3d(r).determinant(), 1, 1e-14);
    EXPECT_LT((stretch - stretch.transpose()).norm(), 1e-13) << "M = R S with a symmetric S";
    // No rotation has a larger trace(RᵀM), because opposite signs of two eigenvalues of S do not increase it.
    const Eigen::Vector3d s = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stretch).eigenvalues();
    EXPECT_GE(s[0] + s[1], -1e-13);
  }
}

TEST(NearestRotation, OfAReflectionIsTheClosestProperRotation) {
  SmallMatrix m = SmallMatrix::Identity(3, 3);
  m(2, 2) = -0.5;
  EXPECT_LT((*nearest_rotation(m) - SmallMatrix::Identity(3, 3)).norm(), 1e-15);
}

TEST(NearestRotation, OfAMatrixOfRankTwoCompletesTheThirdAxis) {
  SmallMatrix m = SmallMatrix::Identity(3, 3);
  m(2, 2) = 0;
  EXPECT_LT((*nearest_rotation(m) - SmallMatrix::Identity(3, 3)).norm(), 1e-15);
}

TEST(NearestRotation, IsEmptyIfTheRotationIsNotUnique) {
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
