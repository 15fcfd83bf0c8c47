// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/block_system.h"

#include <algorithm>

namespace boxplus {
namespace {

/// y += A x for one column-major block.
void add_product(const double* a, std::uint32_t rows, std::uint32_t columns, const double* x, double* y) {
  for (std::uint32_t j = 0; j < columns; ++j, a += rows) {
    const double xj = x[j];
    for (std::uint32_t i = 0; i < rows; ++i) y[i] += a[i] * xj;
  }
}

/// y += Aᵀ x for one column-major block.
void add_transposed_product(const double* a, std::uint32_t rows, std::uint32_t columns, const double* x,
                            double* y) {
  for (std::uint32_t j = 0; j < columns; ++j, a += rows) {
    double sum = 0;
    for (std::uint32_t i = 0; i < rows; ++i) sum += a[i] * x[i];
    y[j] += sum;
  }
}

/// Adds both products with a Rows × Columns block, y_i += A x_j and y_j += Aᵀ x_i, but reads the block only
/// once.
template <std::uint32_t Rows, std::uint32_t Columns>
void add_both_products(const double* a, const double* xi, const double* xj, double* yi, double* yj) {
  double sums[Rows];
  std::copy_n(yi, Rows, sums);
  for (std::uint32_t j = 0; j < Columns; ++j, a += Rows) {
    double sum = 0;
    for (std::uint32_t i = 0; i < Rows; ++i) {
      sums[i] += a[i] * xj[j];
      sum += a[i] * xi[i];
    }
    yj[j] += sum;
  }
  std::copy_n(sums, Rows, yi);
}

void add_both_products(const double* a, std::uint32_t rows, std::uint32_t columns, const double* xi,
                       const double* xj, double* yi, double* yj) {
  const auto is = [&](std::uint32_t r, std::uint32_t c) { return rows == r && columns == c; };
  if (is(3, 3)) return add_both_products<3, 3>(a, xi, xj, yi, yj);
  if (is(6, 6)) return add_both_products<6, 6>(a, xi, xj, yi, yj);
  if (is(6, 3)) return add_both_products<6, 3>(a, xi, xj, yi, yj);
  if (is(9, 3)) return add_both_products<9, 3>(a, xi, xj, yi, yj);
  add_product(a, rows, columns, xj, yi);
  add_transposed_product(a, rows, columns, xi, yj);
}

}  // namespace

void AssembledSystem::multiply(const double* x, double* y) const {
  const BlockStructure& s = *structure_;
  std::fill_n(y, s.scalars(), 0.0);
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    const std::uint32_t columns = s.dim(j);
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const std::uint32_t i = s.row[k];
      const double* block = values_.data() + s.value_start[k];
      const double *xi = x + s.offset[i], *xj = x + s.offset[j];
      if (i == j) {
        add_product(block, columns, columns, xj, y + s.offset[j]);
      } else {
        add_both_products(block, s.dim(i), columns, xi, xj, y + s.offset[i], y + s.offset[j]);
      }
    }
  }
}

void AssembledSystem::block_diagonal(double* out) const {
  const BlockStructure& s = *structure_;
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    const std::uint32_t size = s.dim(j) * s.dim(j);
    out = std::copy_n(values_.data() + s.value_start[s.column_start[j]], size, out);
  }
}

}  // namespace boxplus
