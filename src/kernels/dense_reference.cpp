// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/dense_reference.h"

#include <cmath>

namespace boxplus::dense::reference {

int factor_panel(double* panel, int rows, int columns, int ld, const double* minimum_pivot) {
  for (int j = 0; j < columns; ++j) {
    for (int k = 0; k < j; ++k) {
      for (int i = j; i < rows; ++i) panel[i + j * ld] -= panel[i + k * ld] * panel[j + k * ld];
    }
    const double pivot = panel[j + j * ld];
    if (!(pivot > minimum_pivot[j]) || !std::isfinite(pivot)) return j;
    for (int i = j; i < rows; ++i) panel[i + j * ld] /= std::sqrt(pivot);
  }
  return columns;
}

void set_to_minus_square(double* c, int ldc, const double* a, int lda, int size, int k) {
  for (int j = 0; j < size; ++j) {
    for (int i = j; i < size; ++i) {
      c[i + j * ldc] = 0;
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * a[j + l * lda];
    }
  }
}

void subtract_product_transposed(double* c, int ldc, const double* a, int lda, const double* b, int ldb,
                                 int rows, int columns, int k) {
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) {
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * b[j + l * ldb];
    }
  }
}

void subtract_product(double* c, int ldc, const double* a, int lda, const double* b, int ldb, int rows,
                      int columns, int k) {
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) {
      for (int l = 0; l < k; ++l) c[i + j * ldc] -= a[i + l * lda] * b[l + j * ldb];
    }
  }
}

void divide_by_transposed(double* x, int ldx, const double* l, int ldl, int rows, int size) {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k < j; ++k) x[i + j * ldx] -= x[i + k * ldx] * l[j + k * ldl];
      x[i + j * ldx] /= l[j + j * ldl];
    }
  }
}

void divide_by(double* x, int ldx, const double* l, int ldl, int rows, int size) {
  for (int i = 0; i < rows; ++i) {
    for (int j = size - 1; j >= 0; --j) {
      for (int k = j + 1; k < size; ++k) x[i + j * ldx] -= x[i + k * ldx] * l[k + j * ldl];
      x[i + j * ldx] /= l[j + j * ldl];
    }
  }
}

void solve_forward(const double* panel, int rows, int columns, int ld, double* work) {
  for (int j = 0; j < columns; ++j) {
    work[j] /= panel[j + j * ld];
    for (int i = j + 1; i < rows; ++i) work[i] -= panel[i + j * ld] * work[j];
  }
}

void solve_backward(const double* panel, int rows, int columns, int ld, double* work) {
  for (int j = columns - 1; j >= 0; --j) {
    for (int i = j + 1; i < rows; ++i) work[j] -= panel[i + j * ld] * work[i];
    work[j] /= panel[j + j * ld];
  }
}

}  // namespace boxplus::dense::reference
