// SPDX-License-Identifier: BSD-3-Clause
// Finds the edges that robust kernels reject at the current estimates.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

struct RejectionCounts {
  std::uint32_t rejected = 0;         ///< edges whose weight is below Report::kRejectedWeight
  std::uint32_t redescending = 0;     ///< edges whose kernel is redescending
  std::uint32_t by_redescending = 0;  ///< rejected edges whose kernel is redescending
};

/// Counts the enabled active edges that have a robust kernel. Evaluates each of them once, on at most
/// `workers` threads. Allocates nothing.
RejectionCounts count_rejected(const Graph& graph, const Plan& plan, int workers);

/// A flag for each active edge, in the order of the plan: whether a redescending kernel rejects it.
std::vector<std::uint8_t> flag_rejected(const Graph& graph, const Plan& plan);

}  // namespace boxplus
