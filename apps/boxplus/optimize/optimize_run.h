// SPDX-License-Identifier: BSD-3-Clause
// The work of `boxplus optimize` after reading the graph and before writing the result.
#pragma once

#include "boxplus/optimize/report.h"
#include "optimize/optimize_options.h"
#include "optimize/progress.h"
#include "optimize/report_json.h"

namespace boxplus::app {

/// Sets the requested robust kernel on the chosen edges. Returns the facts about the kernel for the report.
KernelFacts robustify(Graph& graph, const KernelArguments& arguments);

/// Optimizes the graph and shows progress, until the run ends or a signal raises the flag of Interrupt.
Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress);

}  // namespace boxplus::app
