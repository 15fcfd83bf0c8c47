// SPDX-License-Identifier: BSD-3-Clause
#include "linear/pcg/pcg.h"

#include <algorithm>
#include <cmath>

#include "boxplus/base/error.h"
#include "kernels/dense_kernels.h"
#include "linear/finite_check.h"
#include "linear/lost_pivot.h"

namespace boxplus {
namespace {

constexpr int kMinimumIterations = 100;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
  }
  for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// y += factor x.
void add_scaled(double factor, const std::vector<double>& x, std::vector<double>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

}  // namespace

void Pcg::analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/) {
  structure_ = &structure;
  system_ = nullptr;
  std::size_t values = 0;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j)
    values += std::size_t{structure.dim(j)} * structure.dim(j);
  preconditioner_.resize(values);
  for (auto* vector : {&damping_, &minimum_pivot_, &b_, &x_, &r_, &z_, &p_, &q_})
    vector->resize(structure.scalars());
}

FactorResult Pcg::factorize(const BlockSystem& system, const Damping& damping,
                            std::span<const std::uint32_t> /*changed_columns*/) {
  system_ = nullptr;
  if (!structure_) throw InvalidArgument("Pcg::factorize: expected a call of analyze() before");
  if (stop().raised()) return {LinearStatus::kStopped};
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
    if (dense::factor_panel(block, size, size, size, limit) < size)
      return {LinearStatus::kNotPositiveDefinite, j};
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

/// Conjugate gradients from x_ with residual r_, until the recurrence says ‖r‖ ≤ target.
SolveResult Pcg::iterate(double target, int& iterations_left) {
  precondition(r_.data(), z_.data());
  p_ = z_;
  double rz = dot(r_, z_);
  for (int iteration = 0;; ++iteration) {
    const double residual = std::sqrt(dot(r_, r_));
    if (residual <= target) return {LinearStatus::kOk, iteration};
    if (!std::isfinite(residual)) return {LinearStatus::kNotFinite, iteration};
    if (stop().raised()) return {LinearStatus::kStopped, iteration};
    if (iterations_left-- <= 0) return {LinearStatus::kNotConverged, iteration};
    multiply(p_.data(), q_.data());
    const double curvature = dot(p_, q_);
    if (std::isnan(curvature)) return {LinearStatus::kNotFinite, iteration};
    if (curvature <= 0) return {LinearStatus::kNotPositiveDefinite, iteration};
    const double alpha = rz / curvature;
    add_scaled(alpha, p_, x_);
    add_scaled(-alpha, q_, r_);
    precondition(r_.data(), z_.data());
    const double next = dot(r_, z_), beta = next / rz;
    rz = next;
    for (std::size_t i = 0; i < p_.size(); ++i) p_[i] = z_[i] + beta * p_[i];
  }
}

/// Solves into x_. Rounding lets the residual of the recurrence drift from the true one: where they differ at
/// the end, the iteration starts again from the true one.
SolveResult Pcg::solve_one(const double* b, const SolveControl& control) {
  const std::size_t size = structure_->scalars();
  std::copy_n(b, size, b_.data());
  std::fill(x_.begin(), x_.end(), 0.0);
  r_ = b_;
  const double target = control.relative_tolerance * std::sqrt(dot(b_, b_));
  int left = control.max_iterations > 0 ? control.max_iterations
                                        : std::max(kMinimumIterations, 2 * static_cast<int>(size));
  SolveResult total;
  for (double previous = INFINITY;;) {
    const SolveResult part = iterate(target, left);
    total.iterations += part.iterations;
    total.status = part.status;
    if (part.status != LinearStatus::kOk) return total;
    multiply(x_.data(), q_.data());
    for (std::size_t i = 0; i < size; ++i) r_[i] = b_[i] - q_[i];
    const double residual = std::sqrt(dot(r_, r_));
    if (residual <= target) return total;
    if (!(residual < 0.5 * previous)) {  // as small as rounding lets it become
      total.status = LinearStatus::kNotConverged;
      return total;
    }
    previous = residual;
  }
}

SolveResult Pcg::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!system_) throw InvalidArgument("Pcg::solve: expected a successful factorize() before");
  const std::size_t size = structure_->scalars();
  if (!all_finite(b, size * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite, 0};
  SolveResult total;
  for (int c = 0; c < columns; ++c, b += size, x += size) {
    const SolveResult result = solve_one(b, control);
    std::copy_n(x_.data(), size, x);
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
