// SPDX-License-Identifier: BSD-3-Clause
#include "base/symmetric_eigen.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boxplus {
namespace {

TEST(SymmetricEigen, ReconstructsTheMatrixWithOrthonormalVectorsAndAscendingValues) {
  for (int n : {1, 2, 3, 7}) {
    std::srand(static_cast<unsigned>(n));
    const Eigen::MatrixXd B = Eigen::MatrixXd::Random(n, n);
    const Eigen::MatrixXd A = B + B.transpose();
    const SymmetricEigen eigen = symmetric_eigen(A);
    EXPECT_TRUE((eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose()).isApprox(A, 1e-12));
    EXPECT_TRUE((eigen.vectors.transpose() * eigen.vectors).isIdentity(1e-12));
    EXPECT_TRUE(std::is_sorted(eigen.values.begin(), eigen.values.end()));
  }
}

TEST(SymmetricEigen, OfAnEmptyMatrixIsEmpty) {
  const SymmetricEigen eigen = symmetric_eigen(Eigen::MatrixXd(0, 0));
  EXPECT_EQ(eigen.values.size(), 0);
  EXPECT_EQ(eigen.vectors.size(), 0);
}

}  // namespace
}  // namespace boxplus
