// SPDX-License-Identifier: BSD-3-Clause
// The dense arithmetic of the block Cholesky. All matrices are column-major; `ld…` is the leading dimension
// (column stride).
#pragma once

#include "kernels/kernel_table.h"

namespace boxplus::dense {

/// Factorizes a lower trapezoid of rows × columns (rows ≥ columns) values in place: replaces the top square
/// by L11, and the rest by L21 = A21 L11⁻ᵀ. May overwrite the entries above the diagonal with any values.
/// Stops at the first pivot that is not finite or not above minimum_pivot[j], and returns its column;
/// otherwise returns `columns`.
template <class Scalar>
int factor_panel(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot) {
  return factor_kernels<Scalar>().factor_panel(panel, rows, columns, ld, minimum_pivot);
}

/// Computes columns [begin, end) of C = −A Aᵀ, but only the lower triangle. May overwrite the entries above
/// the diagonal. C is size × size, A is size × k. The result does not depend on the ranges into which the
/// caller divides the columns.
template <class Scalar>
void set_to_minus_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin, int end) {
  factor_kernels<Scalar>().set_to_minus_square(c, ldc, a, lda, size, k, begin, end);
}

/// Like set_to_minus_square(), but computes C −= A Aᵀ. Requires k ≤ kBlock.
template <class Scalar>
void subtract_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k, int begin, int end) {
  factor_kernels<Scalar>().subtract_square(c, ldc, a, lda, size, k, begin, end);
}

/// C −= A Bᵀ; C is rows × columns, A is rows × k, B is columns × k.
template <class Scalar>
void subtract_product_transposed(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb,
                                 int rows, int columns, int k) {
  factor_kernels<Scalar>().subtract_product_transposed(c, ldc, a, lda, b, ldb, rows, columns, k);
}

/// C −= A B; C is rows × columns, A is rows × k, B is k × columns.
template <class Scalar>
void subtract_product(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb, int rows,
                      int columns, int k) {
  factor_kernels<Scalar>().subtract_product(c, ldc, a, lda, b, ldb, rows, columns, k);
}

/// X ← X L⁻ᵀ; X is rows × size, L is lower triangular.
template <class Scalar>
void divide_by_transposed(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  factor_kernels<Scalar>().divide_by_transposed(x, ldx, l, ldl, rows, size);
}

/// X ← X L⁻¹; X is rows × size, L is lower triangular.
template <class Scalar>
void divide_by(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  factor_kernels<Scalar>().divide_by(x, ldx, l, ldl, rows, size);
}

/// Forward substitution for one right-hand side: with panel = [L11; L21] and work = [y; z], computes
/// y ← L11⁻¹ y and then z ← z − L21 y.
template <class Scalar>
void solve_forward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  factor_kernels<Scalar>().solve_forward(panel, rows, columns, ld, work);
}

/// Backward substitution for one right-hand side: with panel = [L11; L21] and work = [y; z], computes
/// y ← L11⁻ᵀ (y − L21ᵀ z).
template <class Scalar>
void solve_backward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  factor_kernels<Scalar>().solve_backward(panel, rows, columns, ld, work);
}

}  // namespace boxplus::dense
