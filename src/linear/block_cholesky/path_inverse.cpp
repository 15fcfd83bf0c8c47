// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/path_inverse.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "base/paced_stop.h"
#include "kernels/dense_kernels.h"

namespace boxplus {

PathInverse::PathInverse(const SymbolicFactor& symbolic, std::span<const InverseRequest> requests)
    : symbolic_(symbolic), requests_(requests), first_row_(symbolic.fronts.size(), kNone) {
  for (const InverseRequest& request : requests) {
    blocks_.push_back(symbolic.position[request.block.row]);
    blocks_.push_back(symbolic.position[request.block.column]);
  }
  std::sort(blocks_.begin(), blocks_.end());
  blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
  first_column_.push_back(0);
  for (const std::uint32_t block : blocks_) {
    first_column_.push_back(first_column_.back() + symbolic.dim(block));
    for (std::uint32_t f = symbolic.front_of[block]; f != kNoParent && first_row_[f] == kNone;
         f = symbolic.fronts[f].parent) {
      first_row_[f] = rows_;
      rows_ += symbolic.fronts[f].columns;
      factor_values_ += std::uint64_t{symbolic.fronts[f].columns} * symbolic.fronts[f].leading;
      fronts_.push_back(f);
    }
  }
  std::sort(fronts_.begin(), fronts_.end());
}

double PathInverse::flops() const {
  const double columns = first_column_.back();
  return 2 * columns * static_cast<double>(factor_values_) + 2 * columns * columns * rows_;
}

double* PathInverse::values_at(std::uint32_t position) {
  const std::uint32_t f = symbolic_.front_of[position];
  const std::uint32_t row =
      first_row_[f] + symbolic_.offset[position] - symbolic_.offset[symbolic_.fronts[f].first_block];
  return y_.data() + std::size_t{row} * first_column_.back();
}

bool PathInverse::compute(const double* panels, const StopToken& stop) {
  constexpr std::int64_t kNumbers = 1 << 13;  // the number of values of the factor between two checks
  const std::size_t columns = first_column_.back();
  y_.assign(rows_ * columns, 0.0);
  below_.resize(symbolic_.most_below * columns);
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    double* const values = values_at(blocks_[k]) + first_column_[k];
    for (std::size_t i = 0; i < symbolic_.dim(blocks_[k]); ++i) values[i * (columns + 1)] = 1;
  }
  PacedStop pace(stop, kNumbers);
  for (const std::uint32_t f : fronts_) {
    const Front& front = symbolic_.fronts[f];
    if (pace.is_raised_after(std::int64_t{front.leading} * front.columns)) return false;
    substitute(front, panels);
  }
  write_blocks();
  return true;
}

/// Substitutes forward: divides the rows of the supernode's pivots by L11, and subtracts their multiples from
/// the rows below.
void PathInverse::substitute(const Front& front, const double* panels) {
  const int columns = static_cast<int>(first_column_.back()), pivots = static_cast<int>(front.columns),
            below = static_cast<int>(front.below), leading = static_cast<int>(front.leading);
  const double* const panel = panels + front.panel;
  double* const y = values_at(front.first_block);
  dense::divide_by_transposed(y, columns, panel, leading, columns, pivots);
  if (below == 0) return;
  const auto for_rows_below = [&](auto&& copy) {
    double* values = below_.data();
    for (const std::uint32_t position : symbolic_.rows(front)) {
      const std::size_t count = std::size_t{symbolic_.dim(position)} * first_column_.back();
      copy(values_at(position), values, count);
      values += count;
    }
  };
  for_rows_below([](const double* in_y, double* values, std::size_t n) { std::copy_n(in_y, n, values); });
  dense::subtract_product_transposed(below_.data(), columns, y, columns, panel + pivots, leading, columns,
                                     below, pivots);
  for_rows_below([](double* in_y, const double* values, std::size_t n) { std::copy_n(values, n, in_y); });
}

void PathInverse::write_blocks() {
  const Eigen::Map<const Eigen::MatrixXd> transposed(y_.data(), first_column_.back(), rows_);
  const Eigen::MatrixXd inverse = transposed * transposed.transpose();
  const auto column_of = [&](std::uint32_t block) {
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), symbolic_.position[block]);
    return first_column_[found - blocks_.begin()];
  };
  for (const InverseRequest& request : requests_) {
    const std::uint32_t rows = symbolic_.dim(symbolic_.position[request.block.row]),
                        columns = symbolic_.dim(symbolic_.position[request.block.column]);
    Eigen::Map<Eigen::MatrixXd>(request.out, rows, columns) =
        inverse.block(column_of(request.block.row), column_of(request.block.column), rows, columns);
  }
}

}  // namespace boxplus
