// SPDX-License-Identifier: BSD-3-Clause
#include "linear/eigen_sparse/eigen_sparse_solver.h"

#include <algorithm>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/block_cholesky.h"
#include "linear/column_inverse.h"
#include "linear/finite_check.h"
#include "linear/lost_pivot.h"

namespace boxplus {

void EigenSparseSolver::analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/,
                                const StopToken& /*stop*/) {
  structure_ = &structure;
  factorized_ = false;
  const auto size = static_cast<Eigen::Index>(structure.scalars());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
      const std::uint32_t block = structure.row[k];
      for (std::uint32_t column = structure.offset[j]; column < structure.offset[j + 1]; ++column) {
        for (std::uint32_t row = std::max(structure.offset[block], column); row < structure.offset[block + 1];
             ++row) {
          entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.0);
        }
      }
    }
  }
  matrix_.resize(size, size);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  diagonal_.resize(size);
  direction_.resize(size);
  solution_.resize(size);
  if (size > 0) factor_.analyzePattern(matrix_);
}

/// Copies the blocks of each block column to the scalar columns of the sparse matrix.
void EigenSparseSolver::load(const BlockSystem& system, const Damping& damping) {
  const BlockStructure& s = *structure_;
  double* to = matrix_.valuePtr();
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t column = 0; column < s.dim(j); ++column) {
      const std::uint32_t scalar = s.offset[j] + column;
      double* const diagonal = to;
      for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
        const std::uint32_t rows = s.dim(s.row[k]), first = s.row[k] == j ? column : 0;
        const double* from = system.values().data() + s.value_start[k] + std::size_t{column} * rows;
        to = std::copy_n(from + first, rows - first, to);
      }
      diagonal_[scalar] = *diagonal += damping(scalar);
    }
  }
}

/// Applies the test that is described at kLostPivot. Does the expensive part of the test only for the first 8
/// suspicious pivots. Returns the scalar of the first lost pivot in the numbering of the structure, or the
/// number of scalars if no pivot is lost.
std::uint32_t EigenSparseSolver::find_lost_pivot() {
  const auto& lower = factor_.matrixL().nestedExpression();
  const auto& to_unpermuted = factor_.permutationPinv().indices();
  const auto unpermuted = [&](Eigen::Index j) { return to_unpermuted.size() > 0 ? to_unpermuted[j] : j; };
  int suspects = 0;
  for (Eigen::Index j = 0; j < lower.cols(); ++j) {
    const double root = lower.valuePtr()[lower.outerIndexPtr()[j]], pivot = root * root;
    const double entry = diagonal_[unpermuted(j)];
    if (pivot <= kLostPivot * entry) return static_cast<std::uint32_t>(unpermuted(j));
    if (pivot >= kSuspiciousPivot * entry || ++suspects > 8) continue;
    direction_.setZero();
    direction_[j] = root;
    factor_.matrixU().solveInPlace(direction_);
    double noise = 0;
    for (Eigen::Index i = 0; i <= j; ++i) noise += diagonal_[unpermuted(i)] * direction_[i] * direction_[i];
    if (!(pivot > kLostPivot * noise)) return static_cast<std::uint32_t>(unpermuted(j));
  }
  return structure_->scalars();
}

FactorResult EigenSparseSolver::explain_failure(const BlockSystem& system, const Damping& damping,
                                                const SolveControl& control) const {
  BlockCholesky other;
  other.analyze(*structure_, {}, control.stop);
  const FactorResult result = other.factorize(system, damping, control);
  if (result.status != LinearStatus::kOk) return result;
  return {LinearStatus::kNotPositiveDefinite, BlockStructure::kAbsent};
}

FactorResult EigenSparseSolver::factorize(const BlockSystem& system, const Damping& damping,
                                          const SolveControl& control) {
  factorized_ = false;
  if (!structure_)
    throw InvalidArgument("EigenSparseSolver::factorize: expected an earlier call of analyze()");
  if (system.values().size() != structure_->nonzero_values()) {
    throw InvalidArgument(
        "EigenSparseSolver::factorize: expected the block values of the analyzed structure");
  }
  if (control.stop.raised()) return {LinearStatus::kStopped};
  const std::uint32_t not_finite = find_not_finite(*structure_, system.values().data(), damping);
  if (not_finite != BlockStructure::kAbsent) return {LinearStatus::kNotFinite, not_finite};
  if (structure_->scalars() > 0) {
    load(system, damping);
    factor_.factorize(matrix_);
    if (factor_.info() != Eigen::Success) return explain_failure(system, damping, control);
    const std::uint32_t lost = find_lost_pivot();
    if (lost != structure_->scalars()) {
      const auto above = std::upper_bound(structure_->offset.begin(), structure_->offset.end(), lost);
      return {LinearStatus::kNotPositiveDefinite,
              static_cast<std::uint32_t>(above - structure_->offset.begin()) - 1, lost};
    }
  }
  factorized_ = true;
  return {};
}

SolveResult EigenSparseSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!factorized_)
    throw InvalidArgument("EigenSparseSolver::solve: expected an earlier successful factorize()");
  const std::size_t size = structure_->scalars();
  if (!all_finite(b, size * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite};
  for (int c = 0; c < columns && size > 0; ++c, b += size, x += size) {
    if (control.stop.raised()) return {LinearStatus::kStopped};
    solution_ = factor_.solve(Eigen::Map<const Eigen::VectorXd>(b, static_cast<Eigen::Index>(size)));
    std::copy_n(solution_.data(), size, x);
  }
  return {.exact = true};
}

bool EigenSparseSolver::selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                                         const StopToken& stop) {
  if (!factorized_)
    throw InvalidArgument("EigenSparseSolver::selected_inverse: expected an earlier successful factorize()");
  std::vector<InverseRequest> requests = list_requests(*structure_, blocks, out);
  return solve_for_inverse(*this, *structure_, requests, stop);
}

LinearStatistics EigenSparseSolver::statistics() const {
  LinearStatistics statistics;
  if (!factorized_ || structure_->scalars() == 0) return statistics;
  const auto& lower = factor_.matrixL().nestedExpression();
  statistics.factor_nonzeros = static_cast<std::uint64_t>(lower.nonZeros());
  for (Eigen::Index j = 0; j < lower.cols(); ++j) {
    const double length = lower.outerIndexPtr()[j + 1] - lower.outerIndexPtr()[j];
    statistics.factor_flops += length * length;
    statistics.largest_front = std::max(statistics.largest_front, static_cast<std::uint32_t>(length));
  }
  statistics.supernodes = structure_->scalars();
  return statistics;
}

}  // namespace boxplus
