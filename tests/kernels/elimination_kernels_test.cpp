// SPDX-License-Identifier: BSD-3-Clause
// Compares the kernels of the Schur complement with plain loops for blocks of any size.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "kernels/every_isa.h"
#include "kernels/kernel_table.h"
#include "linear/schur/elimination_reference.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using dense::EliminationKernels;
using Matrix = Eigen::MatrixXd;

/// The number of extra values behind each array. A kernel that writes too much would overwrite them.
constexpr int kPadding = 8;

void expect_equal(const Matrix& fast, const Matrix& slow) {
  EXPECT_LE((fast - slow).cwiseAbs().maxCoeff(), 1e-13 * (1 + slow.cwiseAbs().maxCoeff()));
}

class EliminationKernelsTest : public EveryIsa {
 protected:
  /// Calls f(rows, dim, kernels) for each size that has a special kernel.
  template <class F>
  void for_each_size(F&& f) {
    int sizes = 0;
    for (int rows = 1; rows <= 24; ++rows) {
      for (int dim = 1; dim <= 8; ++dim) {
        const EliminationKernels* kernels = GetParam()->elimination_kernels_for(rows, dim);
        if (kernels == nullptr) continue;
        SCOPED_TRACE(std::to_string(rows) + " x " + std::to_string(dim));
        f(rows, dim, *kernels);
        ++sizes;
      }
    }
    EXPECT_GE(sizes, 5);
  }
};

TEST_P(EliminationKernelsTest, ExistForCamerasAndPointsOfCommonSizes) {
  constexpr int kCommon[][2] = {{6, 3},  {7, 3},  {9, 3},  {3, 2},  {2, 2},  {3, 3},  {4, 3},  {5, 3}, {8, 3},
                                {10, 3}, {11, 3}, {12, 3}, {14, 3}, {16, 3}, {18, 3}, {22, 3}, {6, 1}};
  for (const auto& [rows, dim] : kCommon) {
    EXPECT_NE(GetParam()->elimination_kernels_for(rows, dim), nullptr) << rows << " x " << dim;
  }
  EXPECT_EQ(GetParam()->elimination_kernels_for(15, 3), nullptr);
}

TEST_P(EliminationKernelsTest, DivideByTheFactorLikeTheReference) {
  std::mt19937 random(1);
  for_each_size([&](int rows, int dim, const EliminationKernels& kernels) {
    const Matrix l = random_matrix(dim, dim, random), w = random_matrix(rows, dim, random);
    for (const int stride : {rows, rows + 3}) {
      Matrix fast = random_matrix(stride * dim + kPadding, 1, random), slow = fast;
      kernels.whitened_block(rows, dim, l.data(), w.data(), fast.data(), stride);
      kEliminationReference.whitened_block(rows, dim, l.data(), w.data(), slow.data(), stride);
      expect_equal(fast, slow);
    }
  });
}

TEST_P(EliminationKernelsTest, SubtractProductsWithBlocksOfOtherSizesLikeTheReference) {
  std::mt19937 random(2);
  for_each_size([&](int rows, int dim, const EliminationKernels& kernels) {
    const std::vector<int> b_rows{rows, 1, 5, rows, 6, 3, 9, rows};
    std::vector<std::uint32_t> targets;
    int b_numbers = 0;
    std::uint32_t c_numbers = 3;
    for (const int n : b_rows) {
      b_numbers += n * dim;
      targets.push_back(c_numbers);
      c_numbers += static_cast<std::uint32_t>(n * rows + 1);
    }
    const Matrix a = random_matrix(rows, dim, random), b = random_matrix(b_numbers, 1, random);
    Matrix fast = random_matrix(static_cast<int>(c_numbers) + kPadding, 1, random), slow = fast;
    const auto subtract = [&](const EliminationKernels& with, Matrix& to) {
      const auto count = static_cast<int>(b_rows.size());
      with.subtract_block_products(rows, dim, a.data(),
                                   {b.data(), b_rows.data(), count, targets.data(), to.data()});
    };
    subtract(kernels, fast);
    subtract(kEliminationReference, slow);
    expect_equal(fast, slow);
  });
}

TEST_P(EliminationKernelsTest, MultiplyVectorsLikeTheReference) {
  std::mt19937 random(3);
  for_each_size([&](int rows, int dim, const EliminationKernels& kernels) {
    const Matrix w = random_matrix(rows, dim, random), x = random_matrix(rows + dim, 1, random);
    Matrix fast = random_matrix(rows + kPadding, 1, random), slow = fast;
    kernels.subtract_block_multiple(rows, dim, w.data(), x.data(), fast.data());
    kEliminationReference.subtract_block_multiple(rows, dim, w.data(), x.data(), slow.data());
    expect_equal(fast, slow);
    fast = slow = random_matrix(dim + kPadding, 1, random);
    kernels.subtract_transposed_multiple(rows, dim, w.data(), x.data(), fast.data());
    kEliminationReference.subtract_transposed_multiple(rows, dim, w.data(), x.data(), slow.data());
    expect_equal(fast, slow);
  });
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EliminationKernelsTest,
                         ::testing::ValuesIn(dense::usable_kernels()), name_of_isa);

}  // namespace
}  // namespace boxplus
