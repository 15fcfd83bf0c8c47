// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pivoting_solver.h"

#include <cmath>
#include <random>
#include <vector>

#include "linear/column_inverse.h"

namespace g2o {
namespace internal {

using boxplus::LinearStatus;

void PivotingSolver::analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints& hints,
                             const boxplus::StopToken& stop) {
  structure_ = &structure;
  has_pattern_ = false;
  cholesky_->analyze(structure, hints, stop);
}

/// Copies both triangles of A + λD to the sparse matrix. Keeps zeros, so that the pattern depends only on the
/// structure.
void PivotingSolver::load(const boxplus::BlockSystem& system, const boxplus::Damping& damping) {
  const boxplus::BlockStructure& s = *structure_;
  const auto index = [](std::uint32_t i) { return static_cast<int>(i); };
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t c = 0; c < s.blocks(); ++c) {
    for (std::uint32_t k = s.column_start[c]; k < s.column_start[c + 1]; ++k) {
      const std::uint32_t r = s.row[k];
      const double* value = system.values().data() + s.value_start[k];
      for (std::uint32_t j = s.offset[c]; j < s.offset[c + 1]; ++j) {
        for (std::uint32_t i = s.offset[r]; i < s.offset[r + 1]; ++i, ++value) {
          entries.emplace_back(index(i), index(j), *value + (i == j ? damping(i) : 0.0));
          if (r != c) entries.emplace_back(index(j), index(i), *value);
        }
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(s.scalars());
  matrix_.resize(size, size);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

/// Scales rows and columns alike until the largest entry of each is about 1 (Ruiz, "A scaling algorithm to
/// equilibrate both rows and columns norms in matrices", 2001).
void PivotingSolver::scale() {
  constexpr int kSweeps = 4;
  scale_.setOnes(matrix_.cols());
  Eigen::VectorXd sweep(matrix_.cols());
  for (int n = 0; n < kSweeps; ++n) {
    for (Eigen::Index j = 0; j < matrix_.cols(); ++j) {
      double largest = 0;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_, j); entry; ++entry)
        largest = std::max(largest, std::abs(entry.value()));
      sweep[j] = largest > 0 ? 1 / std::sqrt(largest) : 1;
    }
    matrix_ = sweep.asDiagonal() * matrix_ * sweep.asDiagonal();
    scale_ = scale_.cwiseProduct(sweep);
  }
}

/// Returns false if the scaled matrix is singular: if a solution is so large that rounding alone could have
/// made it. The right-hand side is random, so that it has a part in each direction.
bool PivotingSolver::factorize_scaled() {
  constexpr double kLargestInverse = 1e12;
  if (!has_pattern_) lu_.analyzePattern(matrix_);
  has_pattern_ = true;
  lu_.factorize(matrix_);
  if (lu_.info() != Eigen::Success) return false;
  std::minstd_rand random;
  Eigen::VectorXd b(matrix_.cols());
  for (double& value : b) value = random() % 2 == 0 ? 1 : -1;
  const Eigen::VectorXd x = lu_.solve(b);
  return x.lpNorm<Eigen::Infinity>() < kLargestInverse;
}

boxplus::FactorResult PivotingSolver::factorize(const boxplus::BlockSystem& system,
                                                const boxplus::Damping& damping,
                                                const boxplus::SolveControl& control) {
  cholesky_result_ = cholesky_->factorize(system, damping, control);
  if (cholesky_result_.status != LinearStatus::kNotPositiveDefinite) return cholesky_result_;
  load(system, damping);
  scale();
  return factorize_scaled() ? boxplus::FactorResult() : cholesky_result_;
}

/// Refines the solution of the LU factorization, and accepts it only if its residual is small.
boxplus::SolveResult PivotingSolver::solve(const double* b, int columns, double* x,
                                           const boxplus::SolveControl& control) {
  if (cholesky_result_.status == LinearStatus::kOk) return cholesky_->solve(b, columns, x, control);
  constexpr int kRefinements = 2;
  constexpr double kLargestResidual = 1e-8;
  const Eigen::Index size = matrix_.cols();
  for (int c = 0; c < columns; ++c, b += size, x += size) {
    const Eigen::VectorXd right = scale_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(b, size));
    Eigen::VectorXd solution = lu_.solve(right), residual = right - matrix_ * solution;
    for (int n = 0; n < kRefinements; ++n) {
      solution += lu_.solve(residual);
      residual = right - matrix_ * solution;
    }
    if (!(residual.norm() <= kLargestResidual * right.norm()))
      return {LinearStatus::kNotPositiveDefinite, 0, false, cholesky_result_.failed_block};
    Eigen::Map<Eigen::VectorXd>(x, size) = scale_.cwiseProduct(solution);
  }
  return {.exact = true};
}

bool PivotingSolver::selected_inverse(std::span<const boxplus::BlockCoordinate> blocks, double* out,
                                      const boxplus::StopToken& stop) {
  if (cholesky_result_.status == LinearStatus::kOk) return cholesky_->selected_inverse(blocks, out, stop);
  std::vector<boxplus::InverseRequest> requests = boxplus::list_requests(*structure_, blocks, out);
  return boxplus::solve_for_inverse(*this, *structure_, requests, stop);
}

}  // namespace internal
}  // namespace g2o
