// SPDX-License-Identifier: BSD-3-Clause
#include "system/planned_system.h"

#include <utility>

#include "boxplus/base/parallel.h"

namespace boxplus {
namespace {

/// The precision that the options ask for. For Gauss-Newton, kAutomatic means kDouble.
Precision resolved_precision(const Options& options) {
  const bool exact_steps = options.algorithm == AlgorithmKind::kGaussNewton;
  return exact_steps && options.precision == Precision::kAutomatic ? Precision::kDouble : options.precision;
}

/// Whether the options need all columns of H. Numeric Jacobians cost too much to be computed again.
bool needs_all_columns(const Options& options) {
  return options.numeric_jacobians;
}

}  // namespace

int resolved_threads(const Options& options) {
  return options.threads > 0 ? options.threads : detail::hardware_threads();
}

bool PlannedSystem::update(Graph& graph, const Options& options, const StopToken& stop) {
  if (is_current(graph, options)) return true;
  stop.check();
  make(graph, options, stop);
  return false;
}

/// Whether the plan suits these options. Does not check the revision of the graph.
bool PlannedSystem::suits(const Options& options) const {
  // If the automatic choice was double, the plan also suits Precision::kDouble.
  const Precision wanted = resolved_precision(options);
  const bool has_precision = options_.precision == wanted ||
                             (options_.precision == Precision::kAutomatic && wanted == Precision::kDouble &&
                              system_->facts().statistics.precision == Precision::kDouble);
  const bool has_columns = system_->plan().columns == ColumnStorage::kAll || !needs_all_columns(options);
  return has_precision && has_columns && options_.level == options.level &&
         options_.threads == resolved_threads(options) && options_.gauge == options.gauge &&
         options_.linear_solver == options.linear_solver &&
         options_.custom_linear_solver == options.custom_linear_solver && options_.schur == options.schur &&
         options_.max_factor_bytes == options.max_factor_bytes && options_.vertices == options.vertices &&
         options_.edges == options.edges;
}

void PlannedSystem::make(Graph& graph, const Options& options, const StopToken& stop) {
  system_.reset();  // frees its memory before the new system allocates
  options_ = options;
  options_.callback = {};
  options_.threads = resolved_threads(options);
  options_.precision = resolved_precision(options);
  std::shared_ptr<LinearSolver> solver = options_.custom_linear_solver;
  if (!solver) {
    const LinearSolverOptions of_solver{.block_cholesky = {.precision = options_.precision},
                                        .automatic = {.max_factor_bytes = options_.max_factor_bytes}};
    solver = make_linear_solver(options_.linear_solver, for_newton_steps(of_solver));
  }
  system_ = std::make_unique<BatchSystem>(graph, request(stop), std::move(solver), options_.schur);
  revision_ = graph.revision();
}

PlanRequest PlannedSystem::request(const StopToken& stop) const {
  return {.level = options_.level,
          .vertices = options_.vertices,
          .edges = options_.edges,
          .gauge = options_.gauge,
          .threads = options_.threads,
          .stop = stop,
          .columns = needs_all_columns(options_) ? ColumnStorage::kAll : ColumnStorage::kAutomatic};
}

}  // namespace boxplus
