// SPDX-License-Identifier: BSD-3-Clause
#include "growing/growing_run.h"

#include <fmt/format.h>

#include <limits>

#include "common/program.h"
#include "protocol/serve_commands.h"

namespace boxplus::programs {

void declare(Arguments& arguments, GrowingOptions& options) {
  arguments.count("update", options.solver.update_every, 1, std::numeric_limits<int>::max(),
                  "update the estimates after every n new vertices");
  arguments.flag("v", options.verbose, "print a line per optimization");
  arguments.flag("g", options.draws, "draw the graph with gnuplot after every optimization");
}

GrowingRun::GrowingRun(Graph& graph, const GrowingOptions& options)
    : graph_(graph), options_(options), solver_(graph, options.solver) {
  if (options.draws) gnuplot_ = std::make_unique<Gnuplot>();
}

void GrowingRun::solve() {
  const IncrementalSolver::Work work = solver_.solve();
  if (work == IncrementalSolver::Work::kNothing) return;
  if (options_.verbose) print(work == IncrementalSolver::Work::kBatch ? "batch" : "update");
  if (gnuplot_) gnuplot_->draw(graph_);
}

void GrowingRun::finish() {
  solver_.converge();
  if (options_.verbose) print("batch");
  if (gnuplot_) gnuplot_->draw(graph_);
  const IncrementalSolver::Summary& report = solver_.summary();
  print_remark(fmt::format("{} vertices, {} edges", graph_.vertex_count(), graph_.edge_count()));
  if (!report.converged) print_remark(report.message);
  print_remark(fmt::format("final chi2 = {:.10g}", report.chi2));
}

void GrowingRun::print(const char* work) const {
  const IncrementalSolver::Summary& report = solver_.summary();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  print_error(fmt::format(
      "{}\t vertices= {}\t edges= {}\t chi2= {:.6g}\t iterations= {}\t moved= {}\t time= {:.6f}\t cumTime= "
      "{:.6f}\n",
      work, graph_.vertex_count(), graph_.edge_count(), report.chi2, report.iterations, report.moved,
      report.time_s, elapsed.count()));
}

void serve_protocol(Graph& graph, GrowingRun& run) {
  app::serve_commands(graph, {.solve = [&] { run.solve(); }, .answer = print_output});
}

}  // namespace boxplus::programs
