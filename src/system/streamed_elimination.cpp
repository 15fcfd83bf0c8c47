// SPDX-License-Identifier: BSD-3-Clause
#include "system/streamed_elimination.h"

#include <algorithm>
#include <numeric>

#include "base/stopwatch.h"

namespace boxplus {

void StreamedElimination::run(const Damping& damping, const SolveControl& control,
                              const LinearizeOptions& options, detail::Timings& timings,
                              Linearizer::AfterBatch before) {
  solver_->begin(damping, control);
  std::ranges::fill(seconds_, 0.0);
  const Stopwatch clock;
  linearizer_->linearize(options, slices(), [&](const Linearizer::Batch& batch) {
    before(batch);
    const ScopedTimer adder(seconds_[batch.slice]);
    solver_->eliminate_columns(batch.slice, batch.first, batch.last, batch.values, control.stop);
  });
  const double eliminate_s =
      std::accumulate(seconds_.begin(), seconds_.end(), 0.0) / std::min(linearizer_->workers(), slices());
  timings.factorize_s += eliminate_s;
  timings.linearize_s += clock.seconds() - eliminate_s;
}

SolveResult StreamedElimination::solve(const SolveControl& control, const LinearizeOptions& options,
                                       std::span<double> step) {
  const SolveResult kept = solver_->solve_kept(step.data(), control);
  if (kept.status != LinearStatus::kOk && kept.status != LinearStatus::kNotConverged) return kept;
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  std::copy_n(control.right_hand_side, offset[plan_->eliminated_blocks], step.data());
  linearizer_->subtract_coupling(options, slices(), step.data(), [&](const Linearizer::Batch& batch) {
    for (std::uint32_t e = batch.first; e < batch.last; ++e)
      solver_->solve_eliminated(e, step.data() + offset[e]);
  });
  return linearizer_->stopped() ? SolveResult{LinearStatus::kStopped} : kept;
}

}  // namespace boxplus
