// SPDX-License-Identifier: BSD-3-Clause
// The front door: graph in, optimum and report out.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/optimize/options.h"
#include "boxplus/optimize/report.h"

namespace boxplus {

/// Minimises F(x) = Σ ρ(eᵀΩe) over the graph's free vertices, in place.
///
/// Numerical trouble is a status in the report, never an exception; the estimates are then the best that were
/// found. Throws InvalidArgument for misuse (stale handles in the options, two eliminated vertices in one
/// edge, tolerances that are not numbers); what an error function throws passes through, and the estimates
/// are as before its step.
///
/// The graph keeps the plan of its last call: a call on an unchanged structure with the same options re-uses
/// it, and with a re-used report and edges of fixed size it allocates no memory. Same bits for any number of
/// threads.
Report optimize(Graph& graph, const Options& options = {});
void optimize(Graph& graph, const Options& options, Report& report);

}  // namespace boxplus
