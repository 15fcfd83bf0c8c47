// SPDX-License-Identifier: BSD-3-Clause
#include "engine/client_solver.h"

#include <algorithm>

namespace g2o {
namespace internal {

void ClientSolver::analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints&,
                           const boxplus::StopToken&) {
  structure_ = &structure;
  dims_.clear();
  std::size_t diagonal = 0;
  for (std::uint32_t c = 0; c < structure.blocks(); ++c) {
    dims_.push_back(static_cast<int>(structure.dim(c)));
    diagonal += std::size_t{structure.dim(c)} * structure.dim(c);
  }
  damped_diagonal_.resize(diagonal);
  right_hand_side_.resize(structure.scalars());
  solution_.resize(structure.scalars());
}

boxplus::FactorResult ClientSolver::factorize(const boxplus::BlockSystem& system,
                                              const boxplus::Damping& damping, const boxplus::SolveControl&) {
  blocks_.clear();
  double* out = damped_diagonal_.data();
  for (std::uint32_t c = 0; c < structure_->blocks(); ++c) {
    const std::uint32_t dim = structure_->dim(c);
    for (std::uint32_t k = structure_->column_start[c]; k < structure_->column_start[c + 1]; ++k) {
      const double* block = system.values().data() + structure_->value_start[k];
      if (structure_->row[k] == c) {
        std::copy_n(block, std::size_t{dim} * dim, out);
        for (std::uint32_t i = 0; i < dim; ++i) out[i * (dim + 1)] += damping(structure_->offset[c] + i);
        block = out;
        out += std::size_t{dim} * dim;
      }
      blocks_.push_back({static_cast<int>(structure_->row[k]), static_cast<int>(c), block});
    }
  }
  return {};
}

boxplus::SolveResult ClientSolver::solve(const double* b, int, double* x, const boxplus::SolveControl&) {
  std::copy_n(b, right_hand_side_.size(), right_hand_side_.data());  // a copy that the client may change
  std::fill(solution_.begin(), solution_.end(), 0.0);
  if (!(*client_)(dims_, blocks_, solution_.data(), right_hand_side_.data()))
    return {boxplus::LinearStatus::kNotPositiveDefinite};
  std::copy(solution_.begin(), solution_.end(), x);
  return {};
}

}  // namespace internal
}  // namespace g2o
