// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "boxplus/base/error.h"
#include "boxplus/diagnose/diagnose.h"
#include "boxplus/optimize/optimizer.h"
#include "command_line/message.h"
#include "files/interrupt.h"
#include "optimize/fix_for_run.h"

namespace boxplus::app {
void set_pixel_sigma(Graph& graph, const OptimizeArguments& arguments) {
  if (arguments.pixel_sigma == 0) return;
  if (set_pixel_sigma(graph, arguments.pixel_sigma) == 0)
    throw InvalidArgument("--pixel-sigma: expected a graph with reprojection errors, got one without");
}

KernelFacts set_kernels(Graph& graph, const RunSettings& settings) {
  if (settings.kernel.empty()) return {};
  KernelFacts facts = robustify(graph, settings);
  if (facts.edges == 0 && settings.kernel_scope == KernelScope::kLoopClosures)
    print_message("the graph has no loop closures, so no edge gets the kernel");
  return facts;
}

void doubt_indefinite(const Graph& graph, const OptimizeArguments& arguments, Report& report) {
  if (!report.converged()) return;
  Options options = arguments.options;
  options.vertices = find_vertices(graph, arguments.moving, "--only-vertices");
  const std::vector<VertexRef> any = options.vertices.empty() ? graph.all_vertices() : options.vertices;
  const bool has_minimum = covariance(graph, {any.front()}, options).ok();
  if (has_minimum && diagnose(graph, options).at_minimum) return;
  report.status = Report::Status::kNotConverged;
  report.reason = Report::Reason::kNoStepFound;
  report.message =
      has_minimum ? "an information matrix is indefinite, and the estimates are not at a minimum"
                  : "an information matrix is indefinite, and so is the Hessian: there is no minimum here";
}

Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress, LiveView* view) {
  Options options = arguments.options;
  options.vertices = find_vertices(graph, arguments.moving, "--only-vertices");
  options.stop = Interrupt::flag();
  options.callback = [&progress, view](const IterationRecord& record) {
    progress.iteration(record);
    return view == nullptr || view->watch(record);
  };
  const FixForRun fixed(graph, arguments);
  progress.stage("preparing …");
  Report report = optimize(graph, options);
  progress.erase();
  return report;
}

OutlierReport run_find_outliers(Graph& graph, const OptimizeArguments& arguments, Progress& progress) {
  const FixForRun fixed(graph, arguments);
  return run_find_outliers(graph, arguments.options, *arguments.suspects, progress);
}

OutlierReport run_find_outliers(Graph& graph, const Options& options, Suspects suspects, Progress& progress) {
  OutlierOptions search{.options = options, .suspects = suspects};
  search.options.stop = Interrupt::flag();
  search.options.callback = [&progress](const IterationRecord& record) {
    progress.iteration(record);
    return true;
  };
  progress.stage("finding outliers …");
  OutlierReport found = find_outliers(graph, search);
  progress.erase();
  return found;
}

void require_certifiable(const Graph& graph, const OptimizeArguments& arguments) {
  const std::string obstacle = why_not_certifiable(graph, arguments.options);
  if (!obstacle.empty())
    throw InvalidArgument("--certify: expected a graph of relative poses, but " + obstacle);
}

Certificate run_certify(Graph& graph, const OptimizeArguments& arguments, double run_s, Progress& progress) {
  CertificateOptions options{.options = arguments.options};
  options.options.stop = Interrupt::flag();
  options.options.time_limit_s = std::max(0.0, options.options.time_limit_s - run_s);
  progress.stage("certifying …");
  Certificate certificate = certify(graph, options);
  progress.erase();
  return certificate;
}

}  // namespace boxplus::app
