// SPDX-License-Identifier: BSD-3-Clause
#include "growing/incremental_solver.h"

namespace boxplus::programs {

IncrementalSolver::IncrementalSolver(Graph& graph, const IncrementalOptions& options)
    : graph_(graph), options_(options), smoother_(graph, {.stop = options.stop}) {}

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
  const SmootherReport report = smoother_.update();
  summary_ = {graph_.chi2(), report.time_s,      report.iterations,
              report.moved,  report.converged(), report.message};
  at_update_ = count;
  return Work::kUpdate;
}

void IncrementalSolver::converge() {
  Options options;
  options.start = Start::kAutomatic;
  options.stop = options_.stop;
  if (options_.pcg) options.linear_solver = LinearSolverKind::kPcg;
  const Report report = optimize(graph_, options);
  summary_ = {report.chi2_final, report.time.total_s, report.iterations,
              report.vertices,   report.converged(),  report.message};
  at_update_ = at_batch_ = graph_.vertex_count();
}

}  // namespace boxplus::programs
