// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/mixed_factor.h"

#include <algorithm>

#include "kernels/kernel_table.h"
#include "linear/block_cholesky/find_lost_pivot.h"
#include "linear/block_cholesky/triangular_solve.h"

namespace boxplus {
namespace {

/// The largest number of refinement steps. If a solution needs more, a factor in double is the better choice.
constexpr int kMostSteps = 12;

}  // namespace

void MixedFactor::allocate(const SymbolicFactor& symbolic, const BlockStructure& structure,
                           double steps_that_pay) {
  symbolic_ = &symbolic;
  structure_ = &structure;
  steps_that_pay_ = steps_that_pay;
  most_steps_ = 0;
  factor_.allocate(symbolic, structure.scalars(), 1);
  refinement_.resize(structure.scalars());
  for (auto* vector : {&damping_, &solution_}) vector->resize(structure.scalars());
}

void MixedFactor::release() {
  factor_.release();
  refinement_ = {};
}

LinearStatus MixedFactor::factorize(std::span<const double> values, const Damping& damping,
                                    const StopToken& stop) {
  system_.emplace(*structure_, values);
  for (std::uint32_t i = 0; i < structure_->scalars(); ++i) damping_[i] = damping(i);
  const LinearStatus status =
      factorize_fronts(*symbolic_, *structure_, values.data(), damping, stop, factor_).status;
  if (status != LinearStatus::kOk) return status;
  const bool lost = find_lost_pivot(*symbolic_, *structure_, factor_) != structure_->scalars();
  return lost ? LinearStatus::kNotPositiveDefinite : LinearStatus::kOk;
}

SolveResult MixedFactor::solve(const double* b, double* x, const SolveControl& control) {
  const auto multiply = [this](const double* p, double* q) {
    system_->multiply(p, q);
    for (std::size_t i = 0; i < damping_.size(); ++i) q[i] += damping_[i] * p[i];
  };
  const auto precondition = [this, &control](const double* r, double* z) {
    solve_with(*symbolic_, *structure_, factor_, r, 1, z, control.stop);
  };
  const SolveResult result = refinement_.solve(multiply, precondition, b, solution_.data(),
                                               {control.relative_tolerance, kMostSteps, control.stop});
  most_steps_ = std::max(most_steps_, result.iterations);
  if (result.status == LinearStatus::kOk) std::copy(solution_.begin(), solution_.end(), x);
  return result;
}

double steps_that_pay(double seconds, double flops, double numbers, const BlockStructure& structure) {
  constexpr double kMinSeconds = 1e-3;  // the shortest time of a factorization for which float is considered
  constexpr double kFloatShare = 0.5;   // the time of float relative to double, per operation or value
  constexpr double kSavedOfTheRest = 0.3;      // the fraction of the remaining time that float saves
  constexpr double kSecondsPerByte = 0.8e-10;  // the time to read a byte of the factor or of A
  constexpr double kSecondsPerScalar = 5e-9;   // the time for the vectors of conjugate gradients, per step
  if (seconds < kMinSeconds) return 0;
  const double operations = flops * dense::kernels().nanoseconds_per_flop * 1e-9;
  const double saved = (1 - kFloatShare) * operations + kSavedOfTheRest * (seconds - operations);
  const double read_factor = 2 * numbers * sizeof(double) * kSecondsPerByte;
  const double read_matrix =
      2 * static_cast<double>(structure.nonzero_values()) * sizeof(double) * kSecondsPerByte;
  return (saved + read_factor) /
         (kFloatShare * read_factor + read_matrix + kSecondsPerScalar * structure.scalars());
}

}  // namespace boxplus
