// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_run.h"

#include "boxplus/optimize/optimizer.h"
#include "command_line/message.h"
#include "optimize/interrupt.h"

namespace boxplus::app {
namespace {

/// Fixes vertices for one run, and releases them afterwards. Vertices that were fixed before, by FIX lines of
/// the file, stay fixed.
class FixForRun {
 public:
  FixForRun(Graph& graph, const std::vector<VertexRef>& vertices) : graph_(graph) {
    for (const VertexRef& vertex : vertices) {
      if (graph.is_fixed(vertex)) continue;
      graph.fix(vertex);
      fixed_.push_back(vertex);
    }
  }
  ~FixForRun() {
    for (const VertexRef& vertex : fixed_) graph_.unfix(vertex);
  }
  FixForRun(const FixForRun&) = delete;
  FixForRun& operator=(const FixForRun&) = delete;

 private:
  Graph& graph_;
  std::vector<VertexRef> fixed_;
};

}  // namespace

viewer::KernelFacts set_kernels(Graph& graph, const viewer::RunSettings& settings) {
  if (settings.kernel.empty()) return {};
  viewer::KernelFacts facts = viewer::robustify(graph, settings);
  if (facts.edges == 0 && settings.kernel_scope == viewer::KernelScope::kLoopClosures)
    print_message("the graph has no loop closures, so no edge gets the kernel");
  return facts;
}

Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress, LiveView* view) {
  Options options = arguments.options;
  options.vertices = find_vertices(graph, arguments.moving, "--only-vertices");
  options.stop = Interrupt::flag();
  options.callback = [&progress, view](const IterationRecord& record) {
    progress.iteration(record);
    return view == nullptr || view->watch(record);
  };
  const FixForRun fixed(graph, find_vertices(graph, arguments.fixed, "--fix"));
  progress.stage("preparing …");
  Report report = optimize(graph, options);
  progress.erase();
  return report;
}

OutlierReport run_find_outliers(Graph& graph, const OptimizeArguments& arguments, Progress& progress) {
  OutlierOptions options;
  options.options = arguments.options;
  options.options.stop = Interrupt::flag();
  options.options.callback = [&progress](const IterationRecord& record) {
    progress.iteration(record);
    return true;
  };
  const FixForRun fixed(graph, find_vertices(graph, arguments.fixed, "--fix"));
  progress.stage("finding outliers …");
  OutlierReport found = find_outliers(graph, options);
  progress.erase();
  return found;
}

}  // namespace boxplus::app
