// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace boxplus::detail {

/// The wall-clock seconds that the parts of a run took.
struct Timings {
  double plan_s = 0, start_s = 0, linearize_s = 0, factorize_s = 0, solve_s = 0, evaluate_s = 0, total_s = 0;
};

}  // namespace boxplus::detail
