// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/inverse_on_pattern.h"

#include <algorithm>
#include <cstddef>

#include "kernels/dense_kernels.h"

namespace boxplus {
namespace {

void transpose(const double* from, std::size_t rows, std::size_t columns, double* to) {
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t i = 0; i < rows; ++i) to[j + i * columns] = from[i + j * rows];
  }
}

}  // namespace

void InverseOnPattern::compute(const SymbolicFactor& symbolic, const double* panels) {
  const std::size_t below = symbolic.most_below, columns = symbolic.most_columns;
  panels_.resize(symbolic.panel_size);
  below_.resize(below * below);
  ratio_.resize(below * columns);
  ratio_transposed_.resize(below * columns);
  for (std::size_t s = symbolic.fronts.size(); s-- > 0;) {
    compute_front(symbolic, symbolic.fronts[s], panels + symbolic.fronts[s].panel);
  }
  computed_ = true;
}

void InverseOnPattern::compute_front(const SymbolicFactor& symbolic, const Front& front,
                                     const double* panel) {
  const std::size_t below = front.below, columns = front.columns, leading = front.leading;
  const int m = static_cast<int>(below), n = static_cast<int>(columns), ld = static_cast<int>(leading);
  double* z = panels_.data() + front.panel;
  std::fill_n(z, leading * columns, 0.0);
  for (std::size_t j = 0; j < columns; ++j) z[j * (leading + 1)] = 1;
  dense::divide_by_transposed(z, ld, panel, ld, n, n);
  dense::divide_by(z, ld, panel, ld, n, n);
  if (below == 0) return;
  for (std::size_t j = 0; j < columns; ++j) {
    std::copy_n(panel + j * leading + columns, below, ratio_.data() + j * below);
  }
  dense::divide_by(ratio_.data(), m, panel, ld, m, n);
  transpose(ratio_.data(), below, columns, ratio_transposed_.data());
  gather_below(symbolic, front);
  dense::subtract_product(z + columns, ld, below_.data(), m, ratio_.data(), m, m, n, m);
  dense::subtract_product(z, ld, ratio_transposed_.data(), n, z + columns, ld, n, n, m);
}

/// Copies both triangles of Z22, block by block, from the panels of the front's ancestors.
void InverseOnPattern::gather_below(const SymbolicFactor& symbolic, const Front& front) {
  const auto rows = symbolic.rows(front);
  const std::uint32_t* offsets = symbolic.row_offsets.data() + front.row_begin;
  const std::size_t below = front.below;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    const Front& owner = symbolic.fronts[symbolic.front_of[rows[b]]];
    const std::size_t column = offsets[b] - front.columns, width = symbolic.dim(rows[b]);
    const std::uint32_t first_scalar = symbolic.offset[owner.first_block];
    const double* z =
        panels_.data() + owner.panel + std::size_t{symbolic.offset[rows[b]] - first_scalar} * owner.leading;
    std::uint32_t next = owner.row_begin;  // the rows of both fronts ascend
    for (std::size_t a = b; a < rows.size(); ++a) {
      const std::size_t row = offsets[a] - front.columns, height = symbolic.dim(rows[a]);
      const double* from = z + symbolic.offset[rows[a]] - first_scalar;
      if (rows[a] >= owner.end_block) {
        while (symbolic.row_blocks[next] != rows[a]) ++next;
        from = z + symbolic.row_offsets[next];
      }
      for (std::size_t j = 0; j < width; ++j, from += owner.leading) {
        for (std::size_t i = 0; i < height; ++i) {
          below_[row + i + (column + j) * below] = from[i];
          below_[column + j + (row + i) * below] = from[i];
        }
      }
    }
  }
}

bool InverseOnPattern::read(const SymbolicFactor& symbolic, std::uint32_t row, std::uint32_t column,
                            double* out) const {
  const auto [low, high] = std::minmax(row, column);
  const Front& owner = symbolic.fronts[symbolic.front_of[low]];
  const std::uint32_t first_row = symbolic.row_in(owner, high);
  if (first_row == kNoParent) return false;
  const double* z =
      panels_.data() + owner.panel + first_row + std::size_t{symbolic.row_in(owner, low)} * owner.leading;
  const std::size_t row_step = row == high ? 1 : owner.leading, column_step = row == high ? owner.leading : 1;
  for (std::size_t j = 0; j < symbolic.dim(column); ++j) {
    for (std::size_t i = 0; i < symbolic.dim(row); ++i) *out++ = z[i * row_step + j * column_step];
  }
  return true;
}

}  // namespace boxplus
