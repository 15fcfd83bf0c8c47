// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/reference_cholesky.h"

#include "kernels/dense_reference.h"

namespace boxplus {

ReferenceCholesky::ReferenceCholesky(const BlockStructure& structure, std::span<const double> values,
                                     const Damping& damping)
    : structure_(structure) {
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
      const auto block =
          values.subspan(structure.value_start[k], structure.value_start[k + 1] - structure.value_start[k]);
      blocks_[{j, structure.row[k]}].assign(block.begin(), block.end());
    }
    const std::uint32_t dim = structure.dim(j);
    for (std::uint32_t i = 0; i < dim; ++i)
      blocks_[{j, j}][i * (dim + 1)] += damping(structure.offset[j] + i);
  }
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    if (!factor_diagonal(j)) {
      result_ = {LinearStatus::kNotPositiveDefinite, j};
      return;
    }
    divide_column(j);
    update_with(j);
  }
}

std::vector<std::uint32_t> ReferenceCholesky::rows_below(std::uint32_t column) const {
  std::vector<std::uint32_t> rows;
  for (auto entry = blocks_.upper_bound({column, column});
       entry != blocks_.end() && entry->first.first == column; ++entry) {
    rows.push_back(entry->first.second);
  }
  return rows;
}

bool ReferenceCholesky::factor_diagonal(std::uint32_t column) {
  const int dim = static_cast<int>(structure_.dim(column));
  const std::vector<double> limits(structure_.dim(column), 0.0);
  return dense::reference::factor_panel(blocks_[{column, column}].data(), dim, dim, dim, limits.data()) ==
         dim;
}

void ReferenceCholesky::divide_column(std::uint32_t column) {
  const int dim = static_cast<int>(structure_.dim(column));
  for (const std::uint32_t row : rows_below(column)) {
    const int rows = static_cast<int>(structure_.dim(row));
    dense::reference::divide_by_transposed(blocks_[{column, row}].data(), rows,
                                           blocks_[{column, column}].data(), dim, rows, dim);
  }
}

void ReferenceCholesky::update_with(std::uint32_t column) {
  const auto rows = rows_below(column);
  for (const std::uint32_t j : rows) {
    for (const std::uint32_t i : rows) {
      if (i < j) continue;
      Block& target = blocks_[{j, i}];
      target.resize(std::size_t{structure_.dim(i)} * structure_.dim(j));  // fill-in
      const int height = static_cast<int>(structure_.dim(i)), width = static_cast<int>(structure_.dim(j));
      dense::reference::subtract_product_transposed(target.data(), height, blocks_[{column, i}].data(),
                                                    height, blocks_[{column, j}].data(), width, height, width,
                                                    static_cast<int>(structure_.dim(column)));
    }
  }
}

std::vector<double> ReferenceCholesky::solve(std::vector<double> b) const {
  const auto dim = [&](std::uint32_t block) { return static_cast<int>(structure_.dim(block)); };
  for (std::uint32_t j = 0; j < structure_.blocks(); ++j) {
    double* y = b.data() + structure_.offset[j];
    dense::reference::solve_forward(blocks_.at({j, j}).data(), dim(j), dim(j), dim(j), y);
    for (const std::uint32_t i : rows_below(j)) {
      dense::reference::subtract_product(b.data() + structure_.offset[i], dim(i), blocks_.at({j, i}).data(),
                                         dim(i), y, dim(j), dim(i), 1, dim(j));
    }
  }
  for (std::uint32_t j = structure_.blocks(); j-- > 0;) {
    double* y = b.data() + structure_.offset[j];
    for (const std::uint32_t i : rows_below(j)) {  // yᵀ −= xᵀ L
      dense::reference::subtract_product(y, 1, b.data() + structure_.offset[i], 1, blocks_.at({j, i}).data(),
                                         dim(i), 1, dim(j), dim(i));
    }
    dense::reference::solve_backward(blocks_.at({j, j}).data(), dim(j), dim(j), dim(j), y);
  }
  return b;
}

}  // namespace boxplus
