// SPDX-License-Identifier: BSD-3-Clause
#include "linear/dense/dense_solver.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"
#include "kernels/dense_kernels.h"
#include "linear/column_inverse.h"
#include "linear/finite_check.h"
#include "linear/lost_pivot.h"

namespace boxplus {
namespace {

constexpr std::uint32_t kMaxScalars = 30000;

std::uint32_t block_of(const BlockStructure& structure, std::uint32_t scalar) {
  const auto above = std::upper_bound(structure.offset.begin(), structure.offset.end(), scalar);
  return static_cast<std::uint32_t>(above - structure.offset.begin()) - 1;
}

}  // namespace

void DenseSolver::analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/,
                          const StopToken& /*stop*/) {
  if (structure.scalars() > kMaxScalars) {
    throw InvalidArgument("DenseSolver: expected at most " + std::to_string(kMaxScalars) + " scalars, got " +
                          std::to_string(structure.scalars()));
  }
  structure_ = &structure;
  factorized_ = inverted_ = false;
  const std::size_t size = structure.scalars();
  matrix_.resize(size * size);
  minimum_pivot_.resize(size);
  direction_.resize(size);
}

void DenseSolver::load(const BlockSystem& system, const Damping& damping) {
  const BlockStructure& s = *structure_;
  const std::size_t size = s.scalars();
  std::fill(matrix_.begin(), matrix_.end(), 0.0);
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const double* from = system.values().data() + s.value_start[k];
      const std::uint32_t rows = s.dim(s.row[k]);
      for (std::uint32_t column = 0; column < s.dim(j); ++column, from += rows) {
        std::copy_n(from, rows, matrix_.data() + (s.offset[j] + column) * size + s.offset[s.row[k]]);
      }
    }
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    matrix_[i * (size + 1)] += damping(i);
    minimum_pivot_[i] = kLostPivot * matrix_[i * (size + 1)];
  }
}

/// Applies the test that is described at kLostPivot.
bool DenseSolver::pivot_is_lost(std::uint32_t scalar) {
  const std::size_t size = structure_->scalars();
  const double root = matrix_[scalar * (size + 1)], pivot = root * root;
  if (pivot >= minimum_pivot_[scalar] * (kSuspiciousPivot / kLostPivot)) return false;
  std::fill(direction_.begin(), direction_.end(), 0.0);
  direction_[scalar] = root;
  const int count = static_cast<int>(scalar) + 1;
  dense::solve_backward(matrix_.data(), count, count, static_cast<int>(size), direction_.data());
  double noise = 0;
  for (std::uint32_t i = 0; i <= scalar; ++i) noise += minimum_pivot_[i] * direction_[i] * direction_[i];
  return !(pivot > noise);
}

FactorResult DenseSolver::factorize(const BlockSystem& system, const Damping& damping,
                                    const SolveControl& control) {
  factorized_ = inverted_ = false;
  if (!structure_) throw InvalidArgument("DenseSolver::factorize: expected an earlier call of analyze()");
  if (system.values().size() != structure_->nonzero_values()) {
    throw InvalidArgument("DenseSolver::factorize: expected the block values of the analyzed structure");
  }
  if (control.stop.raised()) return {LinearStatus::kStopped};
  load(system, damping);
  const auto size = structure_->scalars();
  const int signed_size = static_cast<int>(size);
  auto failed = static_cast<std::uint32_t>(
      dense::factor_panel(matrix_.data(), signed_size, signed_size, signed_size, minimum_pivot_.data()));
  if (failed == size) {
    for (failed = 0; failed < size && !pivot_is_lost(failed);) ++failed;
  }
  if (failed == size) {
    factorized_ = true;
    return {};
  }
  const std::uint32_t not_finite = find_not_finite(*structure_, system.values().data(), damping);
  if (not_finite != BlockStructure::kAbsent) return {LinearStatus::kNotFinite, not_finite};
  return {LinearStatus::kNotPositiveDefinite, block_of(*structure_, failed), failed};
}

SolveResult DenseSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!factorized_) throw InvalidArgument("DenseSolver::solve: expected an earlier successful factorize()");
  const std::size_t size = structure_->scalars();
  const int n = static_cast<int>(size);
  if (!all_finite(b, size * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite};
  for (int c = 0; c < columns; ++c, b += size, x += size) {
    if (control.stop.raised()) return {LinearStatus::kStopped};
    if (b != x) std::copy_n(b, size, x);
    dense::solve_forward(matrix_.data(), n, n, n, x);
    dense::solve_backward(matrix_.data(), n, n, n, x);
  }
  return {.exact = true};
}

/// inverse_ = L⁻ᵀ L⁻¹.
void DenseSolver::form_inverse() {
  if (inverted_) return;
  const std::size_t size = structure_->scalars();
  const int n = static_cast<int>(size);
  inverse_.assign(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) inverse_[i * (size + 1)] = 1;
  dense::divide_by_transposed(inverse_.data(), n, matrix_.data(), n, n, n);
  dense::divide_by(inverse_.data(), n, matrix_.data(), n, n, n);
  inverted_ = true;
}

bool DenseSolver::selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                                   const StopToken& stop) {
  if (!factorized_)
    throw InvalidArgument("DenseSolver::selected_inverse: expected an earlier successful factorize()");
  if (stop.raised()) return false;
  form_inverse();
  const BlockStructure& s = *structure_;
  for (const auto& [block, to] : list_requests(s, blocks, out)) {
    double* target = to;
    for (std::uint32_t j = s.offset[block.column]; j < s.offset[block.column + 1]; ++j) {
      const double* from = inverse_.data() + std::size_t{j} * s.scalars() + s.offset[block.row];
      target = std::copy_n(from, s.dim(block.row), target);
    }
  }
  return true;
}

LinearStatistics DenseSolver::statistics() const {
  if (!structure_) return {};
  const std::uint64_t n = structure_->scalars();
  const double size = structure_->scalars();
  return {n * (n + 1) / 2, size * (size + 1) * (2 * size + 1) / 6, 1, structure_->scalars()};
}

}  // namespace boxplus
