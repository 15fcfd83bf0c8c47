// SPDX-License-Identifier: BSD-3-Clause
#include "prepare.h"

#include <cstdlib>
#include <iostream>
#include <memory>

#include "g2o/core/hyper_dijkstra.h"
#include "g2o/core/robust_kernel.h"
#include "g2o/core/robust_kernel_factory.h"

namespace g2o_tool {

bool fix_gauge(g2o::SparseOptimizer& optimizer, const Options& options) {
  std::vector<int> ids = options.gauge_list;
  if (options.gauge_id >= 0) ids.push_back(options.gauge_id);
  for (const int id : ids) {
    auto* v = optimizer.vertex(id);
    if (v == nullptr) {
      std::cerr << "g2o: there is no vertex " << id << " to fix\n";
      return false;
    }
    v->setFixed(true);
  }
  if (!optimizer.gaugeFreedom()) return true;
  auto* gauge = optimizer.findGauge();
  if (gauge == nullptr) return false;
  std::cerr << "# graph is fixed by vertex " << gauge->id() << '\n';
  gauge->setFixed(true);
  return true;
}

void marginalize_landmarks(g2o::SparseOptimizer& optimizer) {
  const int largest = optimizer.maxDimension();
  for (const auto& [id, v] : optimizer.vertices()) {
    auto* vertex = static_cast<g2o::OptimizableGraph::Vertex*>(v);
    if (vertex->dimension() < largest) vertex->setMarginalized(true);
  }
}

bool add_robust_kernels(g2o::SparseOptimizer& optimizer, const Options& options) {
  const auto creator = g2o::RobustKernelFactory::instance()->creator(options.robust_kernel);
  if (creator == nullptr) return false;
  for (g2o::HyperGraph::Edge* e : optimizer.edges()) {
    const auto& vertices = e->vertices();
    const bool sequential = vertices.size() >= 2 && e->numUndefinedVertices() == 0 &&
                            std::abs(vertices[0]->id() - vertices[1]->id()) == 1;
    if (options.non_sequential && sequential) continue;
    g2o::RobustKernel* kernel = creator->construct();
    if (options.robust_kernel_width > 0) kernel->setDelta(options.robust_kernel_width);
    static_cast<g2o::OptimizableGraph::Edge*>(e)->setRobustKernel(kernel);
  }
  return true;
}

void warn_about_unconnected(g2o::SparseOptimizer& optimizer) {
  g2o::HyperGraph::VertexSet fixed;
  for (const auto& [id, v] : optimizer.vertices())
    if (static_cast<g2o::OptimizableGraph::Vertex*>(v)->fixed()) fixed.insert(v);
  g2o::HyperDijkstra paths(&optimizer);
  g2o::UniformCostFunction cost;
  paths.shortestPaths(fixed, &cost);
  const size_t unreached = optimizer.vertices().size() - paths.visited().size();
  if (!fixed.empty() && unreached > 0)
    std::cerr << "# warning: vertices that are not connected to a fixed vertex: " << unreached << '\n';
}

}  // namespace g2o_tool
