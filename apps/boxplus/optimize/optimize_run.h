// SPDX-License-Identifier: BSD-3-Clause
// What `boxplus optimize` does between reading and writing.
#pragma once

#include "boxplus/optimize/report.h"
#include "optimize/optimize_options.h"
#include "optimize/progress.h"
#include "optimize/report_json.h"

namespace boxplus::app {

/// Gives the chosen edges the robust kernel that was asked for; tells how many.
KernelFacts robustify(Graph& graph, const KernelArguments& arguments);

/// Optimises, showing progress, until it ends or an Interrupt is raised.
Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress);

}  // namespace boxplus::app
