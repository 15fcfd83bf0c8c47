// SPDX-License-Identifier: BSD-3-Clause
// The operations of dense_kernels.h, written as their definitions: what the fast ones are tested against.
#pragma once

namespace boxplus::dense::reference {

int factor_panel(double* panel, int rows, int columns, int ld, const double* minimum_pivot);
void set_to_minus_square(double* c, int ldc, const double* a, int lda, int size, int k);
void subtract_product_transposed(double* c, int ldc, const double* a, int lda, const double* b, int ldb,
                                 int rows, int columns, int k);
void subtract_product(double* c, int ldc, const double* a, int lda, const double* b, int ldb, int rows,
                      int columns, int k);
void divide_by_transposed(double* x, int ldx, const double* l, int ldl, int rows, int size);
void divide_by(double* x, int ldx, const double* l, int ldl, int rows, int size);
void solve_forward(const double* panel, int rows, int columns, int ld, double* work);
void solve_backward(const double* panel, int rows, int columns, int ld, double* work);

}  // namespace boxplus::dense::reference
