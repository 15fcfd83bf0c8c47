// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/dense_reference.h"

#include <cmath>

namespace boxplus::dense::reference {

template <class Scalar>
int factor_panel(Scalar* panel, int rows, int columns, int ld, const Scalar* minimum_pivot) {
  for (int j = 0; j < columns; ++j) {
    for (int k = 0; k < j; ++k) {
      for (int i = j; i < rows; ++i) panel[i + j * ld] -= panel[i + k * ld] * panel[j + k * ld];
    }
    const Scalar pivot = panel[j + j * ld];
    if (!(pivot > minimum_pivot[j]) || !std::isfinite(pivot)) return j;
    for (int i = j; i < rows; ++i) panel[i + j * ld] /= std::sqrt(pivot);
  }
  return columns;
}

template <class Scalar>
void set_to_minus_square(Scalar* c, int ldc, const Scalar* a, int lda, int size, int k) {
  for (int j = 0; j < size; ++j) {
    for (int i = j; i < size; ++i) {
      c[i + j * ldc] = 0;
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * a[j + l * lda];
    }
  }
}

template <class Scalar>
void subtract_product_transposed(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb,
                                 int rows, int columns, int k) {
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) {
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * b[j + l * ldb];
    }
  }
}

template <class Scalar>
void subtract_product(Scalar* c, int ldc, const Scalar* a, int lda, const Scalar* b, int ldb, int rows,
                      int columns, int k) {
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) {
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * b[l + j * ldb];
    }
  }
}

template <class Scalar>
void divide_by_transposed(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < j; ++k) x[i + j * ldx] -= x[i + k * ldx] * l[j + k * ldl];
      x[i + j * ldx] /= l[j + j * ldl];
    }
  }
}

template <class Scalar>
void divide_by(Scalar* x, int ldx, const Scalar* l, int ldl, int rows, int size) {
  for (int i = 0; i < rows; ++i) {
    for (int j = size - 1; j >= 0; --j) {
      for (int k = j + 1; k < size; ++k) x[i + j * ldx] -= x[i + k * ldx] * l[k + j * ldl];
      x[i + j * ldx] /= l[j + j * ldl];
    }
  }
}

template <class Scalar>
void solve_forward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  for (int j = 0; j < columns; ++j) {
    work[j] /= panel[j + j * ld];
    for (int i = j + 1; i < rows; ++i) work[i] -= panel[i + j * ld] * work[j];
  }
}

template <class Scalar>
void solve_backward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  for (int j = columns - 1; j >= 0; --j) {
    for (int i = j + 1; i < rows; ++i) work[j] -= panel[i + j * ld] * work[i];
    work[j] /= panel[j + j * ld];
  }
}

template int factor_panel(double*, int, int, int, const double*);
template void set_to_minus_square(double*, int, const double*, int, int, int);
template void subtract_product_transposed(double*, int, const double*, int, const double*, int, int, int,
                                          int);
template void subtract_product(double*, int, const double*, int, const double*, int, int, int, int);
template void divide_by_transposed(double*, int, const double*, int, int, int);
template void divide_by(double*, int, const double*, int, int, int);
template void solve_forward(const double*, int, int, int, double*);
template void solve_backward(const double*, int, int, int, double*);
template int factor_panel(float*, int, int, int, const float*);
template void set_to_minus_square(float*, int, const float*, int, int, int);
template void subtract_product_transposed(float*, int, const float*, int, const float*, int, int, int, int);
template void subtract_product(float*, int, const float*, int, const float*, int, int, int, int);
template void divide_by_transposed(float*, int, const float*, int, int, int);
template void divide_by(float*, int, const float*, int, int, int);
template void solve_forward(const float*, int, int, int, float*);
template void solve_backward(const float*, int, int, int, float*);

}  // namespace boxplus::dense::reference
