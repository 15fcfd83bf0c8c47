// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/subspace.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

namespace boxplus {
namespace {

TEST(Kernel, IsFoundBesideSingularValuesOfAnySize) {
  for (const double size : {1.0, 1e6, 1e9}) {
    Eigen::MatrixXd A(3, 4), expected(4, 1);
    A << size, size, 0, 0,  //
        0, 1, 1, 0,         //
        0, 0, 0.5, 0.5;
    expected << 1, -1, 1, -1;
    const Eigen::MatrixXd kernel = kernel_of(A, 1e-5);
    ASSERT_EQ(kernel.cols(), 1) << size;
    EXPECT_NEAR(std::abs(kernel.col(0).dot(expected.col(0))), 2, 1e-6) << size;
  }
}

TEST(Kernel, HasVectorsThatAreOnlyNearlyMappedToZero) {
  const Eigen::MatrixXd Q = Eigen::MatrixXd::Random(5, 5).householderQr().householderQ();
  Eigen::VectorXd sizes(5);
  sizes << 3, 1e-7, 2e-3, 1e-9, 0;
  const Eigen::MatrixXd A = sizes.asDiagonal() * Q.transpose();
  const Eigen::MatrixXd kernel = kernel_of(A, 1e-6);
  ASSERT_EQ(kernel.cols(), 3);
  EXPECT_LT((kernel.transpose() * kernel - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-12);
  EXPECT_LT((A * kernel).norm(), 1e-6);
}

TEST(Kernel, OfAMatrixWithoutRowsIsEverything) {
  EXPECT_EQ(kernel_of(Eigen::MatrixXd(0, 3), 1e-5).cols(), 3);
}

}  // namespace
}  // namespace boxplus
