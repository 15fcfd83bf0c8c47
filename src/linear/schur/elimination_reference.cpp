// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/elimination_reference.h"

namespace boxplus {
namespace {

void whitened_block(int rows, int dim, const double* l, const double* w, double* y, int y_stride) {
  for (int p = 0; p < dim; ++p) {
    for (int r = 0; r < rows; ++r) {
      double sum = w[r + p * rows];
      for (int q = 0; q < p; ++q) sum -= y[r + q * y_stride] * l[p + q * dim];
      y[r + p * y_stride] = sum * l[p + p * dim];
    }
  }
}

void subtract_block_products(int rows, int dim, const double* a, const dense::BlockProducts& products) {
  const double* b = products.b;
  for (int k = 0; k < products.count; ++k) {
    const int cols = products.b_rows[k];
    double* c = products.values + products.targets[k];
    for (int p = 0; p < dim; ++p) {
      for (int j = 0; j < cols; ++j) {
        for (int i = 0; i < rows; ++i) c[i + j * rows] -= a[i + p * rows] * b[j + p * cols];
      }
    }
    b += cols * dim;
  }
}

void subtract_block_multiple(int rows, int dim, const double* w, const double* x, double* y) {
  for (int p = 0; p < dim; ++p) {
    for (int r = 0; r < rows; ++r) y[r] -= w[r + p * rows] * x[p];
  }
}

void subtract_transposed_multiple(int rows, int dim, const double* w, const double* x, double* y) {
  for (int p = 0; p < dim; ++p) {
    double sum = 0;
    for (int r = 0; r < rows; ++r) sum += w[r + p * rows] * x[r];
    y[p] -= sum;
  }
}

}  // namespace

const dense::EliminationKernels kEliminationReference{whitened_block, subtract_block_products,
                                                      subtract_block_multiple, subtract_transposed_multiple};

}  // namespace boxplus
