// SPDX-License-Identifier: BSD-3-Clause
#include "growing/incremental_solver.h"

namespace boxplus::programs {

IncrementalSolver::IncrementalSolver(Graph& graph, const IncrementalOptions& options)
    : graph_(graph), options_(options), optimizer_(graph) {}

IncrementalSolver::Work IncrementalSolver::solve() {
  const std::size_t count = graph_.vertex_count();
  const auto is_due = [count](std::size_t last, int every) {
    return every > 0 && count >= last + static_cast<std::size_t>(every);
  };
  if (is_due(at_batch_, options_.batch_every)) {
    converge();
    return Work::kBatch;
  }
  if (!is_due(at_update_, options_.update_every)) return Work::kNothing;
  run(1, Start::kCurrent);
  at_update_ = count;
  return Work::kUpdate;
}

void IncrementalSolver::converge() {
  run(Options{}.max_iterations, Start::kAutomatic);
  at_update_ = at_batch_ = graph_.vertex_count();
}

void IncrementalSolver::run(int iterations, Start start) {
  hold_gauge();
  Options options;
  options.max_iterations = iterations;
  options.start = start;
  options.stop = options_.stop;
  if (options_.pcg) options.linear_solver = LinearSolverKind::kPcg;
  optimizer_.set_options(options);
  optimizer_.run(report_);
}

void IncrementalSolver::hold_gauge() {
  if (!may_hold_) return;
  may_hold_ = false;
  const VertexRef* first = nullptr;
  const std::vector<VertexRef> vertices = graph_.all_vertices();
  for (const VertexRef& vertex : vertices) {
    if (graph_.is_fixed(vertex)) return;
    if (first == nullptr || graph_.tangent_dim(vertex) > graph_.tangent_dim(*first)) first = &vertex;
  }
  if (first == nullptr) return;
  graph_.fix(*first);
  held_ = *first;
  holds_ = true;
}

void IncrementalSolver::release_gauge() {
  may_hold_ = false;
  if (holds_) graph_.unfix(held_);
  holds_ = false;
}

}  // namespace boxplus::programs
