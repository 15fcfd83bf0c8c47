// SPDX-License-Identifier: BSD-3-Clause
// Judges whether robust kernels reject edges that the result of a run needs.
#pragma once

#include <string>

#include "boxplus/optimize/report.h"
#include "plan/plan.h"

namespace boxplus {

/// Evaluates the edges that have robust kernels at the current estimates, on at most `workers` threads. Fills
/// `rejection`, which must be empty. Allocates nothing unless redescending kernels reject edges.
void find_rejection(Report::RejectionReport& rejection, const Graph& graph, const Plan& plan, int workers);

/// Whether the result is doubtful: see Report::RejectionReport.
bool rejects_too_much(const Report::RejectionReport& rejection);

/// What the kernels reject, and what to do about it. rejects_too_much() must be true.
std::string rejection_text(const Report::RejectionReport& rejection);

}  // namespace boxplus
