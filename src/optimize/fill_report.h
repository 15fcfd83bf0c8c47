// SPDX-License-Identifier: BSD-3-Clause
// What Optimizer::run() writes into its report, besides the start.
#pragma once

#include "boxplus/optimize/report.h"
#include "optimize/batch_system.h"
#include "optimize/descent.h"

namespace boxplus {

/// Empties the report without giving its memory back, and makes room for a run.
void begin_report(Report& report, const Options& options);

/// Everything that is known once the plan is: sizes, solvers, threads, gauge, sources of Jacobians.
void describe_problem(Report& report, const Graph& graph, const BatchSystem& system, const Options& options);

/// How the run ended, with the message for people. Evaluates chi2 at the estimates as they are left.
void finish_report(Report& report, const Graph& graph, BatchSystem& system, RunResult result);

/// The end of a run that was stopped while it planned.
void finish_report_without_plan(Report& report, const Stopped& stopped);

}  // namespace boxplus
