// SPDX-License-Identifier: BSD-3-Clause
#include "incremental.h"

#include <algorithm>

#include "outputs.h"

namespace g2o_tool {
namespace {

/// Estimates v from the vertices that are there, by the first of its edges that can.
void estimate(g2o::OptimizableGraph::Vertex* v, const g2o::HyperGraph::VertexSet& there) {
  if (v->fixed()) return;
  for (g2o::HyperGraph::Edge* u : v->edges()) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(u);
    g2o::HyperGraph::VertexSet from;
    for (g2o::HyperGraph::Vertex* w : e->vertices())
      if (w != v && there.count(w) > 0) from.insert(w);
    const bool complete = from.size() + 1 == e->vertices().size();
    if (!complete || from.empty() || e->initialEstimatePossible(from, v) <= 0) continue;
    e->initialEstimate(from, v);
    return;
  }
}

}  // namespace

int grow(g2o::SparseOptimizer& optimizer, const Options& options) {
  std::vector<g2o::OptimizableGraph::Vertex*> vertices;
  for (const auto& [id, v] : optimizer.vertices())
    vertices.push_back(static_cast<g2o::OptimizableGraph::Vertex*>(v));
  std::sort(vertices.begin(), vertices.end(), g2o::OptimizableGraph::VertexIDCompare());
  g2o::HyperGraph::VertexSet there;
  int iterations = 0, waiting = 0;
  for (g2o::OptimizableGraph::Vertex* v : vertices) {
    estimate(v, there);
    there.insert(v);
    if (++waiting < options.update_every && v != vertices.back()) continue;
    waiting = 0;
    if (optimizer.terminate()) break;
    if (!optimizer.initializeOptimization(there)) continue;
    iterations += std::max(0, optimizer.optimize(options.iterations > 0 ? options.iterations : 1));
    if (options.gui_output) stream_gnuplot(optimizer);
  }
  optimizer.initializeOptimization();
  return iterations;
}

}  // namespace g2o_tool
