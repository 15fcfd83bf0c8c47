// SPDX-License-Identifier: BSD-3-Clause
// The kernels for panels and fronts, which divide them into blocks, strips and register tiles.
#pragma once

#include <cmath>

#include "kernels/kernel_table.h"
#include "kernels/micro_kernels.h"

namespace boxplus::dense::BOXPLUS_ISA {

template <class Scalar>
constexpr Scalar largest() {
  return sizeof(Scalar) == sizeof(double) ? static_cast<Scalar>(__DBL_MAX__)
                                          : static_cast<Scalar>(__FLT_MAX__);
}

inline int smaller(int a, int b) {
  return a < b ? a : b;
}

template <class Scalar>  // may be a const type
inline Scalar* at(Scalar* a, int ld, int i, int j) {
  return a + i + static_cast<long>(ld) * j;
}

/// Factorizes a tiny square in place. Returns the column of the first bad pivot, or `size` if there is none.
template <class Scalar>
int factor_tiny(Scalar* a, int size, int ld, const Scalar* minimum_pivot, Scalar* inverse_diagonal) {
  for (int j = 0; j < size; ++j) {
    Scalar pivot = a[j + j * ld];
    for (int k = 0; k < j; ++k) pivot -= a[j + k * ld] * a[j + k * ld];
    if (!(pivot > minimum_pivot[j] && pivot <= largest<Scalar>())) return j;
    const Scalar root = std::sqrt(pivot), inverse = 1 / root;
    a[j + j * ld] = root;
    inverse_diagonal[j] = inverse;
    for (int i = j + 1; i < size; ++i) {
      Scalar value = a[i + j * ld];
      for (int k = 0; k < j; ++k) value -= a[i + k * ld] * a[j + k * ld];
      a[i + j * ld] = value * inverse;
    }
  }
  return size;
}

/// Factorizes a panel of few columns by a left-looking method. For each strip of columns, subtracts the
/// product with the columns to the left, factorizes the square on the diagonal, and divides the rows below by
/// it.
template <class Scalar>
int factor_narrow_panel(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot) {
  for (int j = 0; j < columns;) {
    const int width = strip_width(columns - j);
    const Scalar* left = panel + j;
    const Operand<Scalar> top{left, ld, 1};
    Scalar* diagonal = at(panel, ld, j, j);
    run_strip<TileUse::kSubtract>(width, diagonal, ld, left, ld, top, width, j);
    Scalar inverse_diagonal[kStrip];
    const int good = factor_tiny(diagonal, width, ld, minimum_pivot + j, inverse_diagonal);
    if (good < width) return j + good;
    run_strip<TileUse::kDivide>(width, diagonal + width, ld, left + width, ld, top, rows - j - width, j,
                                Triangle<Scalar>{diagonal, ld, inverse_diagonal});
    j += width;
  }
  return columns;
}

/// Computes C −= A Aᵀ or C = −A Aᵀ for the columns [begin, end) of the lower trapezoid. A has k ≤ kBlock
/// columns. If k = 0, `a` may be null.
template <TileUse Use, class Scalar>
void update_trapezoid(Scalar* c, int ldc, const Scalar* a, int lda, int rows, int k, int begin, int end) {
  if (k == 0) a = c;  // `a` is not read, but a null pointer must not be advanced
  for (int j = begin; j < end;) {
    const int width = strip_width(end - j);
    run_strip<Use>(width, at(c, ldc, j, j), ldc, a + j, lda, Operand<Scalar>{a + j, lda, 1}, rows - j, k);
    j += width;
  }
}

template <class Scalar>
void subtract_general(Scalar* c, int ldc, const Scalar* a, int lda, Operand<Scalar> b, int rows, int columns,
                      int k) {
  for (int k0 = 0; k0 < k; k0 += kBlock) {
    const int depth = smaller(kBlock, k - k0);
    const Scalar* left = at(a, lda, 0, k0);
    for (int j = 0; j < columns;) {
      const int width = strip_width(columns - j);
      const Operand<Scalar> right{
          b.data + static_cast<long>(k0) * b.step_k + static_cast<long>(j) * b.step_column, b.step_k,
          b.step_column};
      run_strip<TileUse::kSubtract>(width, at(c, ldc, 0, j), ldc, left, lda, right, rows, depth);
      j += width;
    }
  }
}

template <class Scalar>
void subtract_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin, int end) {
  update_trapezoid<TileUse::kSubtract>(c, ldc, a, lda, size, k, begin, end);
}

template <class Scalar>
void set_to_minus_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin, int end) {
  update_trapezoid<TileUse::kSet>(c, ldc, a, lda, size, smaller(k, kBlock), begin, end);
  for (int k0 = kBlock; k0 < k; k0 += kBlock) {
    subtract_square(c, ldc, at(a, lda, 0, k0), lda, size, smaller(kBlock, k - k0), begin, end);
  }
}

template <class Scalar>
void subtract_product_transposed(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb,
                                 int rows, int columns, int k) {
  subtract_general(c, ldc, a, lda, Operand<Scalar>{b, ldb, 1}, rows, columns, k);
}

template <class Scalar>
void subtract_product(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb, int rows,
                      int columns, int k) {
  subtract_general(c, ldc, a, lda, Operand<Scalar>{b, 1, ldb}, rows, columns, k);
}

template <class Scalar>
void divide_by_transposed(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  for (int j = 0; j < size;) {
    const int width = strip_width(size - j);
    const Scalar* diagonal = at(l, ldl, j, j);
    Scalar inverse_diagonal[kStrip];
    for (int i = 0; i < width; ++i) inverse_diagonal[i] = 1 / diagonal[i + i * ldl];
    run_strip<TileUse::kDivide>(width, at(x, ldx, 0, j), ldx, x, ldx, Operand<Scalar>{l + j, ldl, 1}, rows, j,
                                Triangle<Scalar>{diagonal, ldl, inverse_diagonal});
    j += width;
  }
}

template <class Scalar>
void divide_by(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  // Processes the columns from the last to the first, in strips.
  for (int end = size; end > 0;) {
    const int width = strip_width(end), j = end - width;
    subtract_general(at(x, ldx, 0, j), ldx, at(x, ldx, 0, end), ldx,
                     Operand<Scalar>{at(l, ldl, end, j), 1, ldl}, rows, width, size - end);
    for (int column = end - 1; column >= j; --column) {
      const Scalar inverse = 1 / *at(l, ldl, column, column);
      Scalar* __restrict target = at(x, ldx, 0, column);
      for (int k = column + 1; k < end; ++k) {
        const Scalar factor = *at(l, ldl, k, column);
        const Scalar* source = at(x, ldx, 0, k);
        for (int i = 0; i < rows; ++i) target[i] -= source[i] * factor;
      }
      for (int i = 0; i < rows; ++i) target[i] *= inverse;
    }
    end = j;
  }
}

template <class Scalar>
int factor_panel(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot) {
  for (int j = 0; j < columns; j += kBlock) {
    const int width = smaller(kBlock, columns - j);
    Scalar* block = at(panel, ld, j, j);
    const int good = factor_narrow_panel(block, rows - j, width, ld, minimum_pivot + j);
    if (good < width) return j + good;
    const int next = j + width;
    subtract_square(at(panel, ld, next, next), ld, block + width, ld, rows - next, width, 0, columns - next);
  }
  return columns;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
