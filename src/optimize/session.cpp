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

Session& Session::find(Graph& graph, const Options& options, bool& reused) {
  auto* session = dynamic_cast<Session*>(graph.cache().get());
  if (session != nullptr && session->in_use_)
    throw InvalidArgument(
        "optimize(): this graph is being optimised; a callback or an error function cannot do so");
  reused = session != nullptr && session->fits(graph, options);
  if (reused) return *session;
  auto fresh = std::make_unique<Session>();
  session = fresh.get();
  session->revision_ = graph.revision();
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
  session->plan(graph);
  graph.cache() = std::move(fresh);
  return *session;
}

bool Session::fits(const Graph& graph, const Options& options) const {
  // An own solver may have served another graph since.
  if (own_solver_ || options.own_linear_solver) return false;
  return revision_ == graph.revision() && level_ == options.level && threads_ == resolved_threads(options) &&
         gauge_ == options.gauge && solver_ == options.linear_solver && schur_ == options.schur &&
         max_factor_bytes_ == options.max_factor_bytes && has_precision(resolved_precision(options)) &&
         vertices_ == options.vertices && edges_ == options.edges;
}

/// An automatic choice that came to double serves for double, too.
bool Session::has_precision(Precision wanted) const {
  return precision_ == wanted || (precision_ == Precision::kAutomatic && wanted == Precision::kDouble &&
                                  system_->linear_solver().statistics().precision == Precision::kDouble);
}

void Session::plan(Graph& graph) {
  const PlanRequest request{level_, vertices_, edges_, gauge_, threads_};
  system_.reset();
  AnalyzeHints hints;
  hints.max_factor_bytes = max_factor_bytes_;
  hints.precision = precision_;
  system_ = std::make_unique<BatchSystem>(
      graph, request, own_solver_ ? own_solver_ : std::shared_ptr(make_linear_solver(solver_)), schur_,
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
