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

}  // namespace

void AssembledSystem::multiply(const double* x, double* y) const {
  const BlockStructure& s = *structure_;
  std::fill_n(y, s.scalars(), 0.0);
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    const std::uint32_t columns = s.dim(j);
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const std::uint32_t i = s.row[k];
      const double* block = values_.data() + s.value_start[k];
      add_product(block, s.dim(i), columns, x + s.offset[j], y + s.offset[i]);
      if (i != j) add_transposed_product(block, s.dim(i), columns, x + s.offset[i], y + s.offset[j]);
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
