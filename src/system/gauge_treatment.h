// SPDX-License-Identifier: BSD-3-Clause
// How a system removes the gauge freedom from H.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

/// Some scalars are held, so that the step is zero there. If that is not enough, the diagonal is damped.
struct GaugeTreatment {
  std::vector<std::uint32_t> lost_scalars;  ///< held, because their pivots vanished
  bool holds = true;                        ///< whether the plan's held_scalars are held
  double damping = 0;                       ///< the fraction of itself that is added to each diagonal entry

  void clear();
  /// Whether the plan's held scalars are held. If λ > 0, they are not, because λD already removes the gauge
  /// freedom.
  bool holds_scalars_of(const Plan& plan, double lambda) const {
    return holds && lambda == 0 && !plan.held_scalars.empty();
  }
  /// Calls f(scalar) for each held scalar.
  template <class F>
  void for_each_held(const Plan& plan, double lambda, F&& f) const {
    for (const std::uint32_t i : lost_scalars) f(i);
    if (!holds_scalars_of(plan, lambda)) return;
    for (const std::uint32_t i : plan.held_scalars) f(i);
  }
  /// If the pivot that vanished belongs to a direction of a loose block, holds this direction. If the pivot
  /// belongs to another block, because the solver does not eliminate the loose blocks last, holds the next
  /// direction of a loose block. Returns false if no direction is left. Holding a gauge direction e is
  /// correct: the solution of (H + c e eᵀ) δ = −g is the Gauss-Newton step with eᵀδ = 0.
  bool hold_lost_pivot(const Plan& plan, std::uint32_t block, std::uint32_t scalar);

  bool operator==(const GaugeTreatment&) const = default;
};

}  // namespace boxplus
