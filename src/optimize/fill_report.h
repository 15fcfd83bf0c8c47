// SPDX-License-Identifier: BSD-3-Clause
// Fills the report of Optimizer::run(), except for the description of the start.
#pragma once

#include "boxplus/optimize/report.h"
#include "optimize/descent.h"
#include "optimize/edge_counts.h"
#include "system/run_system.h"

namespace boxplus {

/// Empties the report but keeps its memory, and reserves memory for the records of a run.
void begin_report(Report& report, const Options& options);

/// Fills everything that is known when the plan has been made: sizes, solvers, threads, gauge, and sources of
/// Jacobians. Report::degrees_of_freedom does not count the gauge freedom yet. `counter` lends its memory.
void describe_problem(Report& report, const Graph& graph, RunSystem& system, const Options& options,
                      EdgeCounter& counter);

/// Fills the result of the run and the message for people. Evaluates chi2 at the final estimates.
void finish_report(Report& report, const Graph& graph, RunSystem& system, RunResult result);

/// Fills the result of a run that was stopped while its plan was made.
void finish_report_without_plan(Report& report, const Stopped& stopped);

}  // namespace boxplus
