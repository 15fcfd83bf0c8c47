// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/block_system.h"

#include <gmock/gmock.h>

#include "linear/test_system.h"

namespace boxplus {
namespace {

using ::testing::ElementsAre;

TEST(AssembledSystem, MultipliesLikeTheDenseMatrix) {
  TestSystem system = random_system(12, 10, 1);
  std::mt19937 random(2);
  const Eigen::VectorXd x = random_matrix(system.structure.scalars(), 1, random);
  Eigen::VectorXd y(x.size());
  system.view().multiply(x.data(), y.data());
  EXPECT_LT((y - system.dense() * x).norm(), 1e-12 * y.norm());
}

TEST(AssembledSystem, ReturnsTheDiagonalBlocksInOrder) {
  TestSystem system({1, 2}, {{1, 0}});
  system.block(0, 0) << 5;
  system.block(1, 0) << 7, 8;
  system.block(1, 1) << 1, 2, 3, 4;
  std::vector<double> diagonal(5);
  system.view().block_diagonal(diagonal.data());
  EXPECT_THAT(diagonal, ElementsAre(5, 1, 3, 2, 4));
}

}  // namespace
}  // namespace boxplus
