// SPDX-License-Identifier: BSD-3-Clause
#include "linear/inverse_blocks.h"

#include <algorithm>

#include "base/all_finite.h"

namespace boxplus {

InverseBlocks::InverseBlocks(const BlockStructure& structure, std::span<const BlockCoordinate> pairs)
    : structure_(&structure) {
  std::size_t size = 0;
  for (const auto& [row, column] : pairs) {
    lower_.push_back({std::max(row, column), std::min(row, column)});
    transposed_.push_back(row < column);
    start_.push_back(size);
    size += std::size_t{structure.dim(row)} * structure.dim(column);
  }
  values_.resize(size);
}

bool InverseBlocks::compute(LinearSolver& solver, const StopToken& stop) {
  return solver.selected_inverse(lower_, values_.data(), stop) && all_finite(values_);
}

Eigen::MatrixXd InverseBlocks::block(std::size_t k) const {
  const Eigen::Map<const Eigen::MatrixXd> lower(values_.data() + start_[k], structure_->dim(lower_[k].row),
                                                structure_->dim(lower_[k].column));
  return transposed_[k] ? Eigen::MatrixXd(lower.transpose()) : Eigen::MatrixXd(lower);
}

}  // namespace boxplus
