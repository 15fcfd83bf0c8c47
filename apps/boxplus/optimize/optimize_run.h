// SPDX-License-Identifier: BSD-3-Clause
// The work of `boxplus optimize` after reading the graph and before writing the result.
#pragma once

#include "boxplus/certify/certificate.h"
#include "boxplus/outliers/outliers.h"
#include "command_line/progress.h"
#include "optimize/optimize_options.h"
#include "settings/run_settings.h"
#include "view/live_view.h"

namespace boxplus::app {

/// Some Ω are indefinite. If the result is not at a minimum, says so in the report, which is then not
/// converged.
void doubt_indefinite(const Graph& graph, const OptimizeArguments& arguments, Report& report);
/// Carries out --pixel-sigma. Throws InvalidArgument if there are no reprojection errors.
void set_pixel_sigma(Graph& graph, const OptimizeArguments& arguments);
/// Sets the requested robust kernel on the chosen edges. Returns the facts about the kernel for the report.
KernelFacts set_kernels(Graph& graph, const RunSettings& settings);

/// Optimizes the graph and shows progress, until the run ends, a signal raises the flag of Interrupt, or the
/// user stops it in `view`, which may be null.
Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress, LiveView* view);

/// Does the same, but finds the false edges, and optimizes without them.
OutlierReport run_find_outliers(Graph& graph, const OptimizeArguments& arguments, Progress& progress);
OutlierReport run_find_outliers(Graph& graph, const Options& options, Suspects suspects, Progress& progress);

/// Throws InvalidArgument if the graph cannot be certified.
void require_certifiable(const Graph& graph, const OptimizeArguments& arguments);

/// Certifies the result of a run that took `run_s` of the time limit. If there is a better minimum, the graph
/// gets it.
Certificate run_certify(Graph& graph, const OptimizeArguments& arguments, double run_s, Progress& progress);

}  // namespace boxplus::app
