// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/block_cholesky.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/find_lost_pivot.h"
#include "linear/block_cholesky/triangular_solve.h"
#include "linear/column_inverse.h"
#include "linear/finite_check.h"

namespace boxplus {
namespace {

/// Uses a factor in float only if it would be faster even with this many times the expected number of
/// refinement steps.
constexpr double kStepMargin = 1.3;

}  // namespace

void BlockCholesky::analyze(const BlockStructure& structure, const AnalyzeHints& hints,
                            const StopToken& stop) {
  analyze_if([](const Forecast&) { return true; }, structure, hints, stop);
}

BlockCholesky::Forecast BlockCholesky::forecast_of(const FactorOutline& outline) {
  return {static_cast<std::uint64_t>(outline.partition.numbers * sizeof(double)),
          outline.partition.nanoseconds * 1e-9};
}

void BlockCholesky::complete(const FactorOutline& outline, const BlockStructure& structure,
                             const AnalyzeHints& hints, const StopToken& stop) {
  factorized_ = false;
  inverse_.clear();
  structure_ = nullptr;
  symbolic_ = complete_factor(structure, outline, rule_, hints.threads, stop);
  structure_ = &structure;
  ordering_ = outline.ordering;
  forecast_seconds_ = forecast_of(outline).seconds;
  batch_ = std::max(1, hints.right_hand_sides);
  fell_back_to_double_ = false;
  factor_.release();
  mixed_.release();
  const Precision precision = hints.may_be_singular ? Precision::kDouble : options_.precision;
  const double steps = precision == Precision::kMixed
                           ? std::numeric_limits<double>::infinity()
                           : steps_that_pay(forecast_seconds_, symbolic_.flops,
                                            static_cast<double>(symbolic_.panel_size), structure) /
                                 batch_;
  if (precision != Precision::kDouble && steps >= kStepMargin * kUsualSteps) {
    mixed_.allocate(symbolic_, structure, steps);
  } else {
    factor_.allocate(symbolic_, structure.scalars(), batch_);
  }
}

/// Falls back from float to double until the next analysis.
void BlockCholesky::leave_mixed() {
  mixed_.release();
  fell_back_to_double_ = true;
  factor_.allocate(symbolic_, structure_->scalars(), batch_);
}

/// Falls back to double and factorizes the last system again.
FactorResult BlockCholesky::factorize_again_in_double(const StopToken& stop) {
  leave_mixed();
  return factorize_in_double(mixed_.values().data(), mixed_.damping(), stop);
}

FactorResult BlockCholesky::factorize(const BlockSystem& system, const Damping& damping,
                                      const SolveControl& control) {
  factorized_ = false;
  inverse_.clear();
  if (!structure_) throw InvalidArgument("BlockCholesky::factorize: expected an earlier call of analyze()");
  if (system.values().size() != structure_->nonzero_values()) {
    throw InvalidArgument("BlockCholesky::factorize: expected the block values of the analyzed structure");
  }
  if (control.stop.raised()) return {LinearStatus::kStopped};
  if (mixed_.allocated() && !mixed_.pays()) leave_mixed();
  if (mixed_.allocated()) {
    const LinearStatus status = mixed_.factorize(system.values(), damping, control.stop);
    factorized_ = status == LinearStatus::kOk;
    if (factorized_ || status == LinearStatus::kStopped) return {status};
    leave_mixed();
  }
  return factorize_in_double(system.values().data(), damping, control.stop);
}

FactorResult BlockCholesky::factorize_in_double(const double* values, const Damping& damping,
                                                const StopToken& stop) {
  factorized_ = false;
  const FrontsResult fronts = factorize_fronts(symbolic_, *structure_, values, damping, stop, factor_);
  if (fronts.status == LinearStatus::kStopped) return {fronts.status};
  const std::uint32_t lost = fronts.status == LinearStatus::kOk
                                 ? find_lost_pivot(symbolic_, *structure_, factor_)
                                 : fronts.lost_pivot;
  if (lost != structure_->scalars()) return failure(lost, values, damping);
  factorized_ = true;
  return {};
}

FactorResult BlockCholesky::failure(std::uint32_t permuted_scalar, const double* values,
                                    const Damping& damping) const {
  const std::uint32_t not_finite = find_not_finite(*structure_, values, damping);
  if (not_finite != BlockStructure::kAbsent) return {LinearStatus::kNotFinite, not_finite};
  const auto above = std::upper_bound(symbolic_.offset.begin(), symbolic_.offset.end(), permuted_scalar);
  const auto position = static_cast<std::size_t>(above - symbolic_.offset.begin()) - 1;
  const std::uint32_t block = symbolic_.order[position];
  const std::uint32_t scalar = structure_->offset[block] + permuted_scalar - symbolic_.offset[position];
  return {LinearStatus::kNotPositiveDefinite, block, scalar};
}

SolveResult BlockCholesky::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!factorized_) throw InvalidArgument("BlockCholesky::solve: expected an earlier successful factorize()");
  const std::size_t scalars = structure_->scalars();
  if (!all_finite(b, scalars * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite};
  SolveControl refinement = control;
  refinement.relative_tolerance = std::max(control.relative_tolerance, options_.min_tolerance);
  SolveResult result{.exact = true};
  for (; mixed_.allocated() && columns > 0; --columns, b += scalars, x += scalars) {
    const SolveResult refined = mixed_.solve(b, x, refinement);
    result.iterations += refined.iterations;
    if (refined.status == LinearStatus::kStopped) return {refined.status, result.iterations};
    if (refined.status != LinearStatus::kOk) {
      const FactorResult factor = factorize_again_in_double(control.stop);
      if (factor.status == LinearStatus::kOk) break;
      return {factor.status, result.iterations, false, factor.failed_block, factor.failed_scalar};
    }
    result.exact = false;
  }
  for (int done = 0; done < columns; done += batch_) {
    const int batch = std::min(batch_, columns - done);
    if (control.stop.raised()) return {LinearStatus::kStopped, result.iterations};
    const std::size_t first = static_cast<std::size_t>(done) * scalars;
    if (!solve_with(symbolic_, *structure_, factor_, b + first, batch, x + first, control.stop))
      return {LinearStatus::kStopped, result.iterations};
  }
  return result;
}

/// How to compute blocks of the inverse.
enum class BlockCholesky::InverseMethod : std::uint8_t { kPaths, kColumns, kPattern };

/// The fastest method. A solve and a path perform only two operations for each value of L that they read, per
/// column. So they perform far fewer operations per second than a factorization; a path, with several columns
/// at a time, performs more than a solve.
BlockCholesky::InverseMethod BlockCholesky::fastest_method(std::span<const InverseRequest> requests,
                                                           const PathInverse& paths) const {
  constexpr double kSlowdownOfSolve = 8, kSlowdownOfPaths = 4, kInverseOverFactor = 3;
  std::vector<std::uint32_t> columns;
  columns.reserve(requests.size());
  for (const InverseRequest& request : requests) columns.push_back(request.block.column);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  double scalars = 0;
  for (const std::uint32_t column : columns) scalars += structure_->dim(column);
  const double of_solves = kSlowdownOfSolve * scalars * 4 * static_cast<double>(statistics().factor_nonzeros);
  const double of_paths = kSlowdownOfPaths * paths.flops();
  const double of_pattern =
      inverse_.computed() ? std::numeric_limits<double>::infinity() : kInverseOverFactor * symbolic_.flops;
  if (of_paths <= std::min(of_solves, of_pattern)) return InverseMethod::kPaths;
  return of_solves < of_pattern ? InverseMethod::kColumns : InverseMethod::kPattern;
}

bool BlockCholesky::selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                                     const StopToken& stop) {
  if (!factorized_)
    throw InvalidArgument("BlockCholesky::selected_inverse: expected an earlier successful factorize()");
  if (mixed_.allocated() && factorize_again_in_double(stop).status != LinearStatus::kOk) return false;
  std::vector<InverseRequest> requests = list_requests(*structure_, blocks, out);
  const auto read_from_pattern = [&] {
    std::erase_if(requests, [this](const InverseRequest& request) {
      return inverse_.read(symbolic_, symbolic_.position[request.block.row],
                           symbolic_.position[request.block.column], request.out);
    });
  };
  if (inverse_.computed()) read_from_pattern();
  while (!requests.empty()) {
    PathInverse paths(symbolic_, requests);
    switch (fastest_method(requests, paths)) {
      case InverseMethod::kPaths:
        return paths.compute(factor_.arena(), stop);
      case InverseMethod::kColumns:
        return solve_for_inverse(*this, *structure_, requests, stop);
      case InverseMethod::kPattern:
        inverse_.compute(symbolic_, factor_.arena());
        read_from_pattern();
    }
  }
  return true;
}

LinearStatistics BlockCholesky::statistics() const {
  LinearStatistics statistics;
  for (const Front& front : symbolic_.fronts) {
    const std::uint64_t columns = front.columns;
    statistics.factor_nonzeros += columns * (columns + 1) / 2 + columns * front.below;
  }
  statistics.factor_flops = symbolic_.flops;
  statistics.ordering = ordering_;
  statistics.factor_seconds = forecast_seconds_;
  statistics.precision = mixed_.allocated() ? Precision::kMixed : Precision::kDouble;
  statistics.fell_back_to_double = fell_back_to_double_;
  if (symbolic_.schedule.is_parallel())
    statistics.workers = static_cast<int>(symbolic_.schedule.threads.size());
  statistics.supernodes = static_cast<std::uint32_t>(symbolic_.fronts.size());
  statistics.largest_front = symbolic_.largest_front;
  return statistics;
}

}  // namespace boxplus
