// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/dense_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "kernels/dense_reference.h"
#include "kernels/every_isa.h"
#include "kernels/kernel_table.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using Matrix = Eigen::MatrixXd;
template <class Scalar>
using MatrixOf = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
constexpr int kSizes[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 17, 24, 31, 33, 63, 64, 65, 67, 130};
constexpr int kPadding = 3;
template <class Scalar>
constexpr Scalar kTolerance = static_cast<Scalar>(1e4 * std::numeric_limits<Scalar>::epsilon());

template <class Scalar>
int ld(const MatrixOf<Scalar>& m) {
  return static_cast<int>(m.rows());
}

/// A random matrix with kPadding more rows than requested, so that the leading dimension differs from the
/// number of rows.
template <class Scalar>
MatrixOf<Scalar> padded(int rows, int columns, std::mt19937& random) {
  return random_matrix(rows + kPadding, columns, random).cast<Scalar>();
}

/// A well-conditioned lower triangular matrix, with padding rows.
template <class Scalar>
MatrixOf<Scalar> triangle(int size, std::mt19937& random) {
  MatrixOf<Scalar> l = padded<Scalar>(size, size, random) / static_cast<Scalar>(1 + size);
  for (int i = 0; i < size; ++i) l(i, i) = 1 + std::abs(l(i, i));
  return l;
}

/// The first `rows` rows, with zeros above the diagonal.
template <class Scalar>
MatrixOf<Scalar> lower(const MatrixOf<Scalar>& m, int rows) {
  MatrixOf<Scalar> result = m.topRows(rows);
  for (int j = 0; j < result.cols(); ++j) {
    for (int i = 0; i < std::min(j, rows); ++i) result(i, j) = 0;
  }
  return result;
}

template <class Scalar>
void expect_equal(const MatrixOf<Scalar>& fast, const MatrixOf<Scalar>& slow) {
  EXPECT_LE((fast - slow).cwiseAbs().maxCoeff(), kTolerance<Scalar> * (1 + slow.cwiseAbs().maxCoeff()));
}

class DenseKernels : public EveryIsa {};

/// Runs `check` for both scalar types.
template <class Check>
void for_double_and_float(Check&& check) {
  {
    SCOPED_TRACE("double");
    check.template operator()<double>();
  }
  SCOPED_TRACE("float");
  check.template operator()<float>();
}

TEST_P(DenseKernels, FactorPanelsLikeTheReference) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(1);
    for (const int columns : kSizes) {
      for (const int below : kSizes) {
        if (columns == 0) continue;
        const int rows = columns + below;
        MatrixOf<Scalar> fast = padded<Scalar>(rows, columns, random);
        for (int j = 0; j < columns; ++j) fast(j, j) = static_cast<Scalar>(rows + 1);
        MatrixOf<Scalar> slow = fast;
        const std::vector<Scalar> limits(static_cast<std::size_t>(columns), Scalar{0});
        EXPECT_EQ(dense::factor_panel(fast.data(), rows, columns, ld(fast), limits.data()), columns);
        EXPECT_EQ(dense::reference::factor_panel(slow.data(), rows, columns, ld(slow), limits.data()),
                  columns);
        expect_equal(lower(fast, rows), lower(slow, rows));
        EXPECT_EQ(fast.bottomRows(kPadding), slow.bottomRows(kPadding)) << "wrote below the panel";
      }
    }
  });
}

TEST_P(DenseKernels, ReturnTheFirstColumnWhosePivotIsNotAboveItsLimit) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(2);
    for (const int size : {1, 3, 6, 13, 64, 65, 100}) {
      for (const double bad : {-1.0, 0.0, 0.5, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
        for (int column = 0; column < size; column += 1 + size / 5) {
          MatrixOf<Scalar> panel = MatrixOf<Scalar>::Identity(size + 4, size) * 2;
          panel(column, column) = static_cast<Scalar>(bad);
          const std::vector<Scalar> limits(static_cast<std::size_t>(size), Scalar{0.5});
          EXPECT_EQ(dense::factor_panel(panel.data(), size + 4, size, ld(panel), limits.data()), column);
        }
      }
    }
  });
}

TEST_P(DenseKernels, SquareMatricesLikeTheReference) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(3);
    for (const int size : kSizes) {
      for (const int k : kSizes) {
        if (size == 0) continue;
        const MatrixOf<Scalar> a = padded<Scalar>(size, k, random);
        MatrixOf<Scalar> fast = padded<Scalar>(size, size, random), slow = fast;
        const int middle = size / 3;  // the columns are computed in two parts
        dense::set_to_minus_square(fast.data(), ld(fast), a.data(), ld(a), size, k, 0, middle);
        dense::set_to_minus_square(fast.data(), ld(fast), a.data(), ld(a), size, k, middle, size);
        dense::reference::set_to_minus_square(slow.data(), ld(slow), a.data(), ld(a), size, k);
        expect_equal(lower(fast, size), lower(slow, size));
        EXPECT_EQ(fast.bottomRows(kPadding), slow.bottomRows(kPadding));
      }
    }
  });
}

TEST_P(DenseKernels, MultiplyMatricesLikeTheReference) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(4);
    for (const int rows : kSizes) {
      for (const int columns : {1, 2, 5, 6, 9, 70}) {
        for (const int k : {0, 1, 3, 6, 65}) {
          const MatrixOf<Scalar> a = padded<Scalar>(rows, k, random), b = padded<Scalar>(k, columns, random),
                                 bt = padded<Scalar>(columns, k, random);
          MatrixOf<Scalar> fast = padded<Scalar>(rows, columns, random), slow = fast;
          dense::subtract_product(fast.data(), ld(fast), a.data(), ld(a), b.data(), ld(b), rows, columns, k);
          dense::reference::subtract_product(slow.data(), ld(slow), a.data(), ld(a), b.data(), ld(b), rows,
                                             columns, k);
          expect_equal(fast, slow);
          dense::subtract_product_transposed(fast.data(), ld(fast), a.data(), ld(a), bt.data(), ld(bt), rows,
                                             columns, k);
          dense::reference::subtract_product_transposed(slow.data(), ld(slow), a.data(), ld(a), bt.data(),
                                                        ld(bt), rows, columns, k);
          expect_equal(fast, slow);
        }
      }
    }
  });
}

TEST_P(DenseKernels, DivideByTriangularMatricesLikeTheReference) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(5);
    for (const int rows : kSizes) {
      for (const int size : kSizes) {
        if (size == 0) continue;
        const MatrixOf<Scalar> l = triangle<Scalar>(size, random);
        MatrixOf<Scalar> fast = padded<Scalar>(rows, size, random), slow = fast;
        dense::divide_by(fast.data(), ld(fast), l.data(), ld(l), rows, size);
        dense::reference::divide_by(slow.data(), ld(slow), l.data(), ld(l), rows, size);
        expect_equal(fast, slow);
        dense::divide_by_transposed(fast.data(), ld(fast), l.data(), ld(l), rows, size);
        dense::reference::divide_by_transposed(slow.data(), ld(slow), l.data(), ld(l), rows, size);
        expect_equal(fast, slow);
      }
    }
  });
}

TEST_P(DenseKernels, SolveForwardAndBackwardLikeTheReference) {
  for_double_and_float([]<class Scalar>() {
    std::mt19937 random(6);
    for (const int columns : kSizes) {
      for (const int below : kSizes) {
        if (columns == 0) continue;
        const int rows = columns + below;
        MatrixOf<Scalar> panel = triangle<Scalar>(rows, random).leftCols(columns);
        MatrixOf<Scalar> fast = random_matrix(rows, 1, random).cast<Scalar>(), slow = fast;
        dense::solve_forward(panel.data(), rows, columns, ld(panel), fast.data());
        dense::reference::solve_forward(panel.data(), rows, columns, ld(panel), slow.data());
        expect_equal(fast, slow);
        dense::solve_backward(panel.data(), rows, columns, ld(panel), fast.data());
        dense::reference::solve_backward(panel.data(), rows, columns, ld(panel), slow.data());
        expect_equal(fast, slow);
      }
    }
  });
}

TEST_P(DenseKernels, ComputeTheNormalProductsOfSmallEdgesByTheFormula) {
  using dense::EdgeNumbers;
  std::mt19937 random(7);
  for (int rows = 1; rows <= dense::kMostEdgeRows; ++rows) {
    for (int cols = 1; cols <= dense::kMostEdgeColumns; ++cols) {
      const Matrix jacobian = random_matrix(rows, cols, random), error = random_matrix(rows, 1, random);
      const Matrix root = random_matrix(rows, rows, random), full = root * root.transpose();
      std::vector<const double*> columns;
      for (int c = 0; c < cols; ++c) columns.push_back(jacobian.col(c).data());
      for (const auto kind : {EdgeNumbers::kScalar, EdgeNumbers::kDiagonal, EdgeNumbers::kFull}) {
        std::vector<double> omega;
        Matrix expected = Matrix::Zero(rows, rows);
        for (int i = 0; i < rows; ++i) {
          for (int j = i; j < rows; ++j) {
            if (kind != EdgeNumbers::kFull && i != j) continue;
            expected(i, j) = expected(j, i) = kind == EdgeNumbers::kScalar ? full(0, 0) : full(i, j);
            if (kind != EdgeNumbers::kScalar || i == 0) omega.push_back(expected(i, j));
          }
        }
        constexpr double kWeight = 0.75;
        std::vector<double> products(dense::kMostEdgeColumns * dense::kMostEdgeColumns);
        std::vector<double> gradient(dense::kMostEdgeColumns);
        const int stride = dense::kernels().normal_products(
            {rows, cols, columns.data(), error.data(), kind, omega.data(), kWeight}, products.data(),
            gradient.data());
        const Eigen::Map<const Matrix> all(products.data(), stride, cols);
        expect_equal<double>(all.topRows(cols), kWeight * jacobian.transpose() * expected * jacobian);
        expect_equal<double>(Eigen::Map<const Matrix>(gradient.data(), cols, 1),
                             kWeight * jacobian.transpose() * expected * error);
      }
    }
  }
}

TEST_P(DenseKernels, AddBlocksAndChangeNothingElse) {
  std::mt19937 random(8);
  for (int rows = 1; rows <= 9; ++rows) {
    for (int cols = 1; cols <= 9; ++cols) {
      const Matrix source = random_matrix(16, cols, random);
      Matrix block = random_matrix(rows, cols + 1, random);
      const Matrix before = block;
      dense::kernels().add_block(block.data(), rows, cols, source.data(), 16);
      expect_equal<double>(block.leftCols(cols), before.leftCols(cols) + source.topRows(rows));
      EXPECT_EQ(block.col(cols), before.col(cols));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, DenseKernels, ::testing::ValuesIn(dense::usable_kernels()),
                         name_of_isa);

}  // namespace
}  // namespace boxplus
