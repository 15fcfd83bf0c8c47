// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/session.h"

#include "boxplus/base/parallel.h"

namespace boxplus {
namespace {

/// Options::precision for the algorithm.
Precision resolved_precision(const Options& options) {
  const bool exact_steps = options.algorithm == AlgorithmKind::kGaussNewton;
  return exact_steps && options.precision == Precision::kAutomatic ? Precision::kDouble : options.precision;
}

}  // namespace

int resolved_threads(const Options& options) {
  return options.threads > 0 ? options.threads : hardware_threads();
}

Session& Session::find(Graph& graph, const Options& options, const StopToken& stop, Origin& origin) {
  auto* session = dynamic_cast<Session*>(graph.cache().get());
  if (session != nullptr && session->in_use_)
    throw InvalidArgument(
        "optimize(): this graph is being optimised; a callback or an error function cannot do so");
  const bool suits = session != nullptr && session->suits(options);
  origin = Origin::kReused;
  if (suits && session->revision_ == graph.revision()) return *session;
  stop.check();
  origin = Origin::kExtended;
  if (suits && session->extend(graph, stop)) return *session;
  origin = Origin::kMade;
  auto fresh = std::make_unique<Session>();
  session = fresh.get();
  session->level_ = options.level;
  session->threads_ = resolved_threads(options);
  session->gauge_ = options.gauge;
  session->solver_ = options.linear_solver;
  session->own_solver_ = options.own_linear_solver;
  session->schur_ = options.schur;
  session->max_factor_bytes_ = options.max_factor_bytes;
  session->precision_ = resolved_precision(options);
  session->vertices_ = options.vertices;
  session->edges_ = options.edges;
  graph.cache().reset();  // its memory first
  session->plan(graph, stop);
  session->note_structure(graph);
  graph.cache() = std::move(fresh);
  return *session;
}

void Session::note_structure(const Graph& graph) {
  revision_ = graph.revision();
  vertex_slots_.clear();
  edge_slots_.clear();
  for (const auto& pool : graph.vertex_pools()) vertex_slots_.push_back(pool->slots());
  for (const auto& pool : graph.edge_pools()) edge_slots_.push_back(pool->slots());
}

/// Brings the plan up to date if only additions came since.
bool Session::extend(Graph& graph, const StopToken& stop) {
  if (graph.last_rewrite() > revision_) return false;
  std::unique_ptr<BatchSystem> system = std::move(system_);  // of no use if this throws
  if (!system->extend(request(stop), vertex_slots_, edge_slots_)) return false;
  system_ = std::move(system);
  note_structure(graph);
  return true;
}

/// Whether the session is one for these options, of whatever revision.
bool Session::suits(const Options& options) const {
  // An own solver may have served another graph since.
  if (!system_ || own_solver_ || options.own_linear_solver) return false;
  return level_ == options.level && threads_ == resolved_threads(options) && gauge_ == options.gauge &&
         solver_ == options.linear_solver && schur_ == options.schur &&
         max_factor_bytes_ == options.max_factor_bytes && has_precision(resolved_precision(options)) &&
         vertices_ == options.vertices && edges_ == options.edges;
}

/// An automatic choice that came to double serves for double, too.
bool Session::has_precision(Precision wanted) const {
  return precision_ == wanted || (precision_ == Precision::kAutomatic && wanted == Precision::kDouble &&
                                  system_->linear_solver().statistics().precision == Precision::kDouble);
}

PlanRequest Session::request(const StopToken& stop) const {
  return {level_, vertices_, edges_, gauge_, threads_, stop};
}

void Session::plan(Graph& graph, const StopToken& stop) {
  system_.reset();
  AnalyzeHints hints;
  hints.max_factor_bytes = max_factor_bytes_;
  hints.precision = precision_;
  system_ = std::make_unique<BatchSystem>(
      graph, request(stop), own_solver_ ? own_solver_ : std::shared_ptr(make_linear_solver(solver_)), schur_,
      hints);
}

Algorithm& Session::algorithm(const Options& options) {
  AlgorithmKind kind = options.algorithm;
  if (kind == AlgorithmKind::kAutomatic) {
    kind =
        system_->plan().eliminated_blocks > 0 ? AlgorithmKind::kLevenbergMarquardt : AlgorithmKind::kDogleg;
  }
  auto& algorithm = algorithms_[static_cast<std::size_t>(kind)];
  if (!algorithm) algorithm = make_algorithm(kind);
  return *algorithm;
}

}  // namespace boxplus
