// SPDX-License-Identifier: BSD-3-Clause
#include "linear/pcg/pcg.h"

#include <algorithm>

#include "boxplus/base/error.h"
#include "kernels/dense_kernels.h"
#include "linear/finite_check.h"
#include "linear/lost_pivot.h"

namespace boxplus {

void Pcg::analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/, const StopToken& /*stop*/) {
  structure_ = &structure;
  system_ = nullptr;
  std::size_t values = 0;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j)
    values += std::size_t{structure.dim(j)} * structure.dim(j);
  preconditioner_.resize(values);
  for (auto* vector : {&damping_, &minimum_pivot_}) vector->resize(structure.scalars());
  iteration_.resize(structure.scalars());
}

FactorResult Pcg::factorize(const BlockSystem& system, const Damping& damping, const SolveControl& control) {
  system_ = nullptr;
  if (!structure_) throw InvalidArgument("Pcg::factorize: expected an earlier call of analyze()");
  if (control.stop.raised()) return {LinearStatus::kStopped};
  const BlockStructure& s = *structure_;
  for (std::uint32_t i = 0; i < s.scalars(); ++i) damping_[i] = damping(i);
  system.block_diagonal(preconditioner_.data());
  std::uint32_t failed = find_not_finite_diagonal(s, preconditioner_.data(), damping);
  if (failed == BlockStructure::kAbsent && !system.values().empty()) {
    failed = find_not_finite(s, system.values().data(), damping);
  }
  if (failed != BlockStructure::kAbsent) return {LinearStatus::kNotFinite, failed};
  double* block = preconditioner_.data();
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    const std::uint32_t dim = s.dim(j);
    double* limit = minimum_pivot_.data() + s.offset[j];
    for (std::uint32_t i = 0; i < dim; ++i) {
      block[i * (dim + 1)] += damping_[s.offset[j] + i];
      limit[i] = kLostPivot * block[i * (dim + 1)];
    }
    const int size = static_cast<int>(dim);
    const int good = dense::factor_panel(block, size, size, size, limit);
    if (good < size)
      return {LinearStatus::kNotPositiveDefinite, j, s.offset[j] + static_cast<std::uint32_t>(good)};
    block += std::size_t{dim} * dim;
  }
  system_ = &system;
  return {};
}

/// y = (A + λD) x.
void Pcg::multiply(const double* x, double* y) const {
  system_->multiply(x, y);
  for (std::size_t i = 0; i < damping_.size(); ++i) y[i] += damping_[i] * x[i];
}

void Pcg::precondition(const double* r, double* z) const {
  const BlockStructure& s = *structure_;
  std::copy_n(r, s.scalars(), z);
  const double* block = preconditioner_.data();
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    const int size = static_cast<int>(s.dim(j));
    dense::solve_forward(block, size, size, size, z + s.offset[j]);
    dense::solve_backward(block, size, size, size, z + s.offset[j]);
    block += std::size_t{s.dim(j)} * s.dim(j);
  }
}

SolveResult Pcg::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!system_) throw InvalidArgument("Pcg::solve: expected an earlier successful factorize()");
  const std::size_t size = structure_->scalars();
  if (!all_finite(b, size * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite};
  SolveResult total;
  for (int c = 0; c < columns; ++c, b += size, x += size) {
    const SolveResult result =
        iteration_.solve([this](const double* p, double* q) { multiply(p, q); },
                         [this](const double* r, double* z) { precondition(r, z); }, b, x, control);
    total.iterations += result.iterations;
    if (result.status != LinearStatus::kOk) {
      total.status = result.status;
      return total;
    }
  }
  return total;
}

LinearStatistics Pcg::statistics() const {
  LinearStatistics statistics;
  if (!structure_) return statistics;
  for (std::uint32_t j = 0; j < structure_->blocks(); ++j) {
    const std::uint64_t dim = structure_->dim(j);
    statistics.factor_nonzeros += dim * (dim + 1) / 2;
    statistics.factor_flops += static_cast<double>(dim * (dim + 1) * (2 * dim + 1)) / 6;
    statistics.largest_front = std::max(statistics.largest_front, structure_->dim(j));
  }
  statistics.supernodes = structure_->blocks();
  return statistics;
}

}  // namespace boxplus
