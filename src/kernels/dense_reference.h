// SPDX-License-Identifier: BSD-3-Clause
// Simple implementations of the operations in dense_kernels.h. Tests compare the fast kernels with them.
// Scalar is double or float.
#pragma once

namespace boxplus::dense::reference {

template <class Scalar>
int factor_panel(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot);
template <class Scalar>
void set_to_minus_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k);
template <class Scalar>
void subtract_product_transposed(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb,
                                 int rows, int columns, int k);
template <class Scalar>
void subtract_product(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb, int rows,
                      int columns, int k);
template <class Scalar>
void divide_by_transposed(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size);
template <class Scalar>
void divide_by(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size);
template <class Scalar>
void solve_forward(const Scalar* panel, int rows, int columns, int ld, Scalar* work);
template <class Scalar>
void solve_backward(const Scalar* panel, int rows, int columns, int ld, Scalar* work);

}  // namespace boxplus::dense::reference
