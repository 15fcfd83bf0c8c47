// SPDX-License-Identifier: BSD-3-Clause
// The work of `boxplus optimize` between reading and writing.
#pragma once

#include "boxplus/optimize/report.h"
#include "optimize/optimize_options.h"
#include "optimize/progress.h"
#include "optimize/report_json.h"

namespace boxplus::app {

/// Gives the chosen edges the requested robust kernel; returns their number.
KernelFacts robustify(Graph& graph, const KernelArguments& arguments);

/// Optimizes and shows progress, until the run ends or an Interrupt is raised.
Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress);

}  // namespace boxplus::app
