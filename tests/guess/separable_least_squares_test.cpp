// SPDX-License-Identifier: BSD-3-Clause
#include "guess/separable_least_squares.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

namespace boxplus::guess {
namespace {

constexpr std::uint32_t kConstant = SeparableLeastSquares::kConstant;

struct Term {
  std::uint32_t i;
  SmallMatrix a;
  std::uint32_t j;
  SmallMatrix b, c;
  SmallVector weight;
};

SmallMatrix numbers(int rows, int cols, double first) {
  SmallMatrix m(rows, cols);
  for (int k = 0; k < m.size(); ++k) m.data()[k] = std::sin(first + 1.7 * k + 0.9 * k * k);
  return m;
}

TEST(SeparableLeastSquares, AgreesWithADenseQrDecompositionOfAllTerms) {
  const std::vector<std::uint32_t> dims{3, 1, 3}, offsets{0, 3, 4};
  const SmallVector weight3 = SmallVector::Constant(3, 2.0), weight1 = SmallVector::Constant(1, 0.5);
  const std::vector<Term> terms{
      {0, numbers(3, 3, 1), kConstant, {}, numbers(3, 2, 2), weight3},
      {2, numbers(3, 3, 3), 0, numbers(3, 3, 4), numbers(3, 2, 5), weight3},
      {0, numbers(3, 3, 6), 2, numbers(3, 3, 7), numbers(3, 2, 8), weight3},
      {1, numbers(1, 1, 9), 2, numbers(1, 3, 10), numbers(1, 2, 11), weight1},
      {kConstant, {}, 1, numbers(1, 1, 12), numbers(1, 2, 13), weight1},
  };
  SeparableLeastSquares system(dims, 2);
  for (const Term& t : terms) system.join(t.i, t.j);
  system.finish_structure();
  Eigen::MatrixXd stacked = Eigen::MatrixXd::Zero(11, 7), right(11, 2);
  int row = 0;
  for (const Term& t : terms) {
    system.add(t.i, t.a, t.j, t.b, t.c, t.weight);
    const auto rows = static_cast<int>(t.c.rows());
    const double root = std::sqrt(t.weight[0]);
    if (t.i != kConstant) stacked.block(row, offsets[t.i], rows, t.a.cols()) += root * t.a;
    if (t.j != kConstant) stacked.block(row, offsets[t.j], rows, t.b.cols()) -= root * t.b;
    right.middleRows(row, rows) = root * t.c;
    row += rows;
  }
  ASSERT_EQ(system.solve(), LinearStatus::kOk);
  const Eigen::MatrixXd expected = stacked.colPivHouseholderQr().solve(right);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_LT((system.block(k) - expected.middleRows(offsets[k], dims[k])).norm(), 1e-11) << "block " << k;
  }
}

TEST(SeparableLeastSquares, ReportsASolutionThatIsNotUnique) {
  SeparableLeastSquares system({1, 1}, 2);
  system.join(0, 1);
  system.finish_structure();
  const SmallMatrix one = SmallMatrix::Identity(1, 1);
  system.add(0, one, 1, one, numbers(1, 2, 1), SmallVector::Constant(1, 1.0));
  EXPECT_EQ(system.solve(), LinearStatus::kNotPositiveDefinite);
}

}  // namespace
}  // namespace boxplus::guess
