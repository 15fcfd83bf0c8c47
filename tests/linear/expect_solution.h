// SPDX-License-Identifier: BSD-3-Clause
// Makes right-hand sides for a TestSystem, and compares a solution with the solution of a dense solver.
#pragma once

#include <gtest/gtest.h>

#include "linear/test_system.h"

namespace boxplus {

inline Eigen::MatrixXd right_hand_sides(const TestSystem& system, int columns) {
  std::mt19937 random(99);
  return random_matrix(system.structure.scalars(), columns, random);
}

inline void expect_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& x, const Eigen::MatrixXd& b) {
  EXPECT_LT((a * x - b).norm(), 1e-10 * b.norm());
  const Eigen::MatrixXd expected = a.llt().solve(b);
  EXPECT_LT((x - expected).norm(), 1e-8 * expected.norm());
}

}  // namespace boxplus
