// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_run.h"

#include <map>
#include <memory>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "command_line/message.h"
#include "optimize/interrupt.h"
#include "viewer/scene/edge_roles.h"

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

std::shared_ptr<const RobustKernel> make_kernel(const KernelArguments& arguments, int rows) {
  return arguments.kernel_width ? make_robust_kernel(arguments.kernel, *arguments.kernel_width)
                                : make_default_kernel(arguments.kernel, rows);
}

}  // namespace

KernelFacts robustify(Graph& graph, const KernelArguments& arguments) {
  KernelFacts facts;
  if (arguments.kernel.empty()) return facts;
  facts.name = arguments.kernel;
  facts.width = arguments.kernel_width;
  std::map<int, std::shared_ptr<const RobustKernel>> kernels;  // the key is the number of rows of the edge
  const viewer::EdgeRoles role(graph);
  for (const EdgeRef& edge : graph.all_edges()) {
    if (arguments.kernel_scope == KernelScope::kAll || role(edge) == viewer::EdgeRole::kLoopClosure) {
      const int rows = graph.edge_pools()[edge.pool]->shape(edge.slot).rows;
      std::shared_ptr<const RobustKernel>& kernel = kernels[rows];
      if (!kernel) kernel = make_kernel(arguments, rows);
      graph.set_kernel(edge, kernel);
      if (!facts.width) facts.widths[rows] = kernel->delta();
      ++facts.edges;
    }
  }
  if (facts.edges == 0 && arguments.kernel_scope == KernelScope::kLoopClosures)
    print_message("the graph has no loop closures, so no edge gets the kernel");
  return facts;
}

Report run_optimize(Graph& graph, const OptimizeArguments& arguments, Progress& progress) {
  Options options = arguments.options;
  options.vertices = find_vertices(graph, arguments.moving, "--only-vertices");
  options.stop = Interrupt::flag();
  options.callback = [&progress](const IterationRecord& record) {
    progress.iteration(record);
    return true;
  };
  const FixForRun fixed(graph, find_vertices(graph, arguments.fixed, "--fix"));
  progress.stage("preparing …");
  Report report = optimize(graph, options);
  progress.erase();
  return report;
}

}  // namespace boxplus::app
