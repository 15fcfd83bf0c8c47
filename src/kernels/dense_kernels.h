// SPDX-License-Identifier: BSD-3-Clause
// The dense arithmetic of the block Cholesky. All matrices are column-major; `ld…` is the distance of two
// columns.
#pragma once

namespace boxplus::dense {

/// Cholesky factor, in place, of a lower trapezoid of rows × columns (rows ≥ columns) numbers: the top square
/// is replaced by L11 and the rest by L21 = A21 L11⁻ᵀ. What lies above the diagonal may be overwritten with
/// anything. Stops at the first pivot that is not above minimum_pivot[j] or not finite and returns its
/// column; else `columns`.
int factor_panel(double* panel, int rows, int columns, int ld, const double* minimum_pivot);

/// Columns that are factored together before the rest of a panel is updated: a strip of A over them stays in
/// L1.
inline constexpr int kBlock = 64;

/// Columns [begin, end) of C = −A Aᵀ (lower triangle; entries above the diagonal may be overwritten), C size
/// × size, A size × k. The values do not depend on how the columns are divided into calls.
void set_to_minus_square(double* c, int ldc, const double* a, int lda, int size, int k, int begin, int end);

/// The same for C −= A Aᵀ, k ≤ kBlock.
void subtract_square(double* c, int ldc, const double* a, int lda, int size, int k, int begin, int end);

/// C −= A Bᵀ; C rows × columns, A rows × k, B columns × k.
void subtract_product_transposed(double* c, int ldc, const double* a, int lda, const double* b, int ldb,
                                 int rows, int columns, int k);

/// C −= A B; C rows × columns, A rows × k, B k × columns.
void subtract_product(double* c, int ldc, const double* a, int lda, const double* b, int ldb, int rows,
                      int columns, int k);

/// X ← X L⁻ᵀ; X rows × size, L lower triangular.
void divide_by_transposed(double* x, int ldx, const double* l, int ldl, int rows, int size);

/// X ← X L⁻¹; X rows × size, L lower triangular.
void divide_by(double* x, int ldx, const double* l, int ldl, int rows, int size);

/// One right-hand side, forwards: with panel = [L11; L21] and work = [y; z], y ← L11⁻¹ y, z ← z − L21 y.
void solve_forward(const double* panel, int rows, int columns, int ld, double* work);

/// One right-hand side, backwards: with work = [y; z], y ← L11⁻ᵀ (y − L21ᵀ z).
void solve_backward(const double* panel, int rows, int columns, int ld, double* work);

}  // namespace boxplus::dense
