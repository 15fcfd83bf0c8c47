// SPDX-License-Identifier: BSD-3-Clause
#include "settings/run_settings.h"

#include <memory>

#include "boxplus/robust/default_width.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "graph/graph_view.h"

namespace boxplus {
namespace {

std::shared_ptr<const RobustKernel> make_kernel(const RunSettings& settings, int rows) {
  return settings.kernel_width ? make_robust_kernel(settings.kernel, *settings.kernel_width)
                               : make_default_kernel(settings.kernel, rows);
}

}  // namespace

KernelFacts robustify(Graph& graph, const RunSettings& settings) {
  KernelFacts facts;
  facts.name = settings.kernel;
  if (settings.kernel.empty()) {
    for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, nullptr);
    return facts;
  }
  facts.width = settings.kernel_width;
  std::map<int, std::shared_ptr<const RobustKernel>> kernels;  // the key is the number of rows of the edge
  const EdgeRoles role(graph);
  for (const EdgeRef& edge : graph.all_edges()) {
    if (settings.kernel_scope == KernelScope::kLoopClosures && role(edge) != EdgeRole::kLoopClosure) {
      graph.set_kernel(edge, nullptr);
      continue;
    }
    const int rows = graph.edge_pools()[edge.pool]->shape(edge.slot).rows;
    std::shared_ptr<const RobustKernel>& kernel = kernels[rows];
    if (!kernel) kernel = make_kernel(settings, rows);
    graph.set_kernel(edge, kernel);
    if (!facts.width) facts.widths[rows] = kernel->delta();
    ++facts.edges;
  }
  return facts;
}

}  // namespace boxplus
