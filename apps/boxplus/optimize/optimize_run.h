// SPDX-License-Identifier: BSD-3-Clause
// The work of `boxplus optimize` after reading the graph and before writing the result.
#pragma once

#include "boxplus/optimize/outliers.h"
#include "optimize/optimize_options.h"
#include "optimize/progress.h"
#include "view/live_view.h"
#include "viewer/settings/run_settings.h"

namespace boxplus::app {

/// Sets the requested robust kernel on the chosen edges. Returns the facts about the kernel for the report.
viewer::KernelFacts set_kernels(Graph& graph, const viewer::RunSettings& settings);

/// Optimizes the graph and shows progress, until the run ends, a signal raises the flag of Interrupt, or the
/// user stops it in `view`, which may be null.
Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress, LiveView* view);

/// Does the same, but finds the false loop closures, and optimizes without them.
OutlierReport run_find_outliers(Graph& graph, const OptimizeArguments& arguments, Progress& progress);

}  // namespace boxplus::app
