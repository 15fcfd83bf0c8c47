// SPDX-License-Identifier: BSD-3-Clause
#include "incremental.h"

#include <algorithm>

#include "outputs.h"

namespace g2o_tool {
namespace {

/// Initializes the estimate of v from the vertices in `there`. Takes the first edge of v that can compute the
/// estimate of v from them.
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

bool is_absolute(const g2o::HyperGraph::Edge* e) {
  return e->vertices().size() == 1;
}

/// Fixes one vertex as long as this object exists, unless a fixed vertex or a unary edge already holds the
/// current part of the graph. Fixes the first of the vertices with the largest dimension.
class Hold {
 public:
  explicit Hold(const std::vector<g2o::OptimizableGraph::Vertex*>& there) {
    for (g2o::OptimizableGraph::Vertex* v : there) {
      if (v->fixed() || std::any_of(v->edges().begin(), v->edges().end(), is_absolute)) {
        held_ = nullptr;
        return;
      }
      if (held_ == nullptr || v->dimension() > held_->dimension()) held_ = v;
    }
    if (held_ != nullptr) held_->setFixed(true);
  }
  ~Hold() {
    if (held_ != nullptr) held_->setFixed(false);
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

 private:
  g2o::OptimizableGraph::Vertex* held_ = nullptr;
};

}  // namespace

void grow(g2o::SparseOptimizer& optimizer, const Options& options, Run& run) {
  std::vector<g2o::OptimizableGraph::Vertex*> vertices, there;
  for (const auto& [id, v] : optimizer.vertices())
    vertices.push_back(static_cast<g2o::OptimizableGraph::Vertex*>(v));
  std::sort(vertices.begin(), vertices.end(), g2o::OptimizableGraph::VertexIDCompare());
  g2o::HyperGraph::VertexSet part;
  int waiting = 0;
  for (g2o::OptimizableGraph::Vertex* v : vertices) {
    estimate(v, part);
    part.insert(v);
    there.push_back(v);
    if (++waiting < options.update_every && v != vertices.back()) continue;
    waiting = 0;
    if (optimizer.terminate()) break;
    const Hold hold(there);
    if (!optimizer.initializeOptimization(part)) continue;
    iterate(optimizer, options, options.iterations_given ? options.iterations : 1, run);
    if (options.gui_output) stream_gnuplot(optimizer);
  }
  optimizer.initializeOptimization();
}

}  // namespace g2o_tool
