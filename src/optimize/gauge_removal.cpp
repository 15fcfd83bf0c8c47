// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/gauge_removal.h"

#include <algorithm>
#include <vector>

namespace boxplus {
namespace {

/// GaugePolicy::kDamp, and bounds, increase each diagonal entry by this fraction of itself. This is enough to
/// lift pivots that are only rounding errors, but too little to change a step noticeably.
constexpr double kGaugeDamping = 1e-10;

}  // namespace

double GaugeRemoval::fraction() const {
  const bool is_free = !plan_->freedoms.empty() || !plan_->undetermined_blocks.empty();
  const bool damps = policy_ == GaugePolicy::kDamp || (policy_ == GaugePolicy::kFixFirst && has_bounds_);
  return is_free && damps ? kGaugeDamping : current_.damping;
}

bool GaugeRemoval::has_other_types() const {
  detail::Frame frame;
  return std::any_of(plan_->vertices.begin(), plan_->vertices.end(), [&](const VertexList& list) {
    return !list.slots.empty() && !graph_->vertex_pools()[list.pool]->get_frame(list.slots[0], frame);
  });
}

StepResult GaugeRemoval::solve(const Solver& solver) {
  StepResult result = solver.once();
  if (result.status == LinearStatus::kOk && !solver.held_are_free()) {
    current_.lost_scalars.clear();
    current_.holds = false;
    result = solver.once();
  }
  return result.status == LinearStatus::kNotPositiveDefinite ? hold_or_damp(result, solver) : result;
}

/// Holds directions whose pivots vanish. If that does not help, damps.
StepResult GaugeRemoval::hold_or_damp(StepResult result, const Solver& solver) {
  std::vector<std::uint32_t>& lost = current_.lost_scalars;
  const std::size_t before = lost.size();
  const auto hold_lost_pivot = [&] {
    const auto [block, scalar] = solver.lost_pivot();
    return current_.hold_lost_pivot(*plan_, block, scalar);
  };
  while (result.status == LinearStatus::kNotPositiveDefinite && policy_ == GaugePolicy::kFixFirst &&
         hold_lost_pivot())
    result = solver.once();
  // Without a pivot of a loose block, hold_lost_pivot() can only guess. An edge may measure what it held.
  const bool holds_too_much = result.status == LinearStatus::kOk && !solver.held_are_free();
  if (result.status != LinearStatus::kNotPositiveDefinite && !holds_too_much) return result;
  lost.resize(before);
  const bool holds_too_little = policy_ == GaugePolicy::kFixFirst && !plan_->freedoms.empty();
  const bool damps_too_little = policy_ == GaugePolicy::kDamp && has_other_types();
  if (holds_too_much && current_.damping != 0) return {.status = LinearStatus::kNotPositiveDefinite};
  if ((!holds_too_much && !holds_too_little && !damps_too_little) || current_.damping != 0) return result;
  current_.damping = kGaugeDamping;
  return solver.once();
}

}  // namespace boxplus
