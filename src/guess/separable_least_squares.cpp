// SPDX-License-Identifier: BSD-3-Clause
#include "guess/separable_least_squares.h"

#include <algorithm>
#include <cmath>

namespace boxplus::guess {

void SeparableLeastSquares::join(std::uint32_t i, std::uint32_t j) {
  if (i != kConstant && j != kConstant) pairs_.push_back({std::max(i, j), std::min(i, j)});
}

void SeparableLeastSquares::finish_structure(const StopToken& stop) {
  structure_ = make_block_structure(dims_, pairs_, stop);
  pairs_ = {};
  values_.assign(structure_.nonzero_values(), 0.0);
  x_.assign(std::size_t{structure_.scalars()} * static_cast<std::size_t>(columns_), 0.0);
}

SeparableLeastSquares::Strided SeparableLeastSquares::rows_of(std::uint32_t i) {
  return {x_.data() + structure_.offset[i], static_cast<Eigen::Index>(structure_.dim(i)), columns_,
          Eigen::OuterStride<>(structure_.scalars())};
}

/// Adds AᵀWA to the matrix and AᵀWC to the right-hand side.
void SeparableLeastSquares::add_square(std::uint32_t i, const SmallMatrix& a, const SmallMatrix& c,
                                       const SmallVector& weight) {
  const SmallMatrix weighted = a.transpose() * weight.asDiagonal();
  const std::uint32_t diagonal = structure_.column_start[i];
  Eigen::Map<Eigen::MatrixXd> h(values_.data() + structure_.value_start[diagonal], a.cols(), a.cols());
  h += weighted.lazyProduct(a);
  rows_of(i) += weighted.lazyProduct(c);
}

void SeparableLeastSquares::add(std::uint32_t i, const SmallMatrix& a, std::uint32_t j, const SmallMatrix& b,
                                const SmallMatrix& c, const SmallVector& weight) {
  if (i != kConstant) add_square(i, a, c, weight);
  if (j != kConstant) add_square(j, b, -c, weight);
  if (i == kConstant || j == kConstant) return;
  const SmallMatrix cross = -(a.transpose() * weight.asDiagonal()).lazyProduct(b);
  const std::uint32_t entry = structure_.find(std::max(i, j), std::min(i, j));
  double* values = values_.data() + structure_.value_start[entry];
  if (i > j) {
    Eigen::Map<Eigen::MatrixXd>(values, cross.rows(), cross.cols()) += cross;
  } else {
    Eigen::Map<Eigen::MatrixXd>(values, cross.cols(), cross.rows()) += cross.transpose();
  }
}

LinearStatus SeparableLeastSquares::solve(const GuessLimits& limits, std::span<const std::uint32_t> order) {
  constexpr double kTolerance = 1e-4;  // for iterative solvers; more accuracy would not improve the start
  if (structure_.blocks() == 0) return LinearStatus::kOk;
  if (limits.stop.raised()) return LinearStatus::kStopped;
  LinearSolverOptions options;
  options.block_cholesky.ordering = Ordering::kMinimumDegree;  // dissection is too slow for one factorization
  options.automatic.max_factor_bytes = limits.max_factor_bytes;
  const auto solver = make_linear_solver(LinearSolverKind::kAutomatic, options);
  AnalyzeHints hints;
  hints.right_hand_sides = columns_;
  hints.threads = limits.threads;
  hints.order = order;
  solver->analyze(structure_, hints, limits.stop);
  const AssembledSystem system(structure_, values_);  // some solvers keep a reference to it
  const SolveControl control{.relative_tolerance = kTolerance, .stop = limits.stop};
  const FactorResult factor = solver->factorize(system, Damping{}, control);
  if (factor.status != LinearStatus::kOk) return factor.status;
  const LinearStatus status = solver->solve(x_.data(), columns_, x_.data(), control).status;
  const bool finite = std::all_of(x_.begin(), x_.end(), [](double value) { return std::isfinite(value); });
  return status == LinearStatus::kOk && !finite ? LinearStatus::kNotFinite : status;
}

double SeparableLeastSquares::largest_diagonal() const {
  double largest = 0;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i) {
    const double* block = values_.data() + structure_.value_start[structure_.column_start[i]];
    for (std::uint32_t k = 0; k < structure_.dim(i); ++k) {
      largest = std::max(largest, block[k * (structure_.dim(i) + 1)]);
    }
  }
  return largest;
}

SmallMatrix SeparableLeastSquares::block(std::uint32_t i) const {
  return const_cast<SeparableLeastSquares*>(this)->rows_of(i);
}

}  // namespace boxplus::guess
