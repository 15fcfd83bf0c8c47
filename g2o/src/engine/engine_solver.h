// SPDX-License-Identifier: BSD-3-Clause
// Converts solver settings of the g2o API to solver settings of the engine.
#pragma once

#include <memory>

#include "boxplus/base/parallel.h"
#include "boxplus/linear/make_linear_solver.h"
#include "engine/pivoting_solver.h"
#include "g2o/core/linear_engine.h"

namespace g2o {
namespace internal {

inline boxplus::LinearSolverKind engine_kind(EngineSolver solver) {
  switch (solver) {
    case EngineSolver::kScalarCholesky:
      return boxplus::LinearSolverKind::kEigenSparse;
    case EngineSolver::kDense:
      return boxplus::LinearSolverKind::kDense;
    case EngineSolver::kPcg:
      return boxplus::LinearSolverKind::kPcg;
    default:
      return boxplus::LinearSolverKind::kBlockCholesky;
  }
}

inline boxplus::LinearSolverOptions solver_options(const EngineSettings& settings) {
  boxplus::LinearSolverOptions options;
  if (settings.exact) options.block_cholesky.precision = boxplus::Precision::kDouble;
  return options;
}

/// Makes the solver of `settings`, which must not be kNone.
inline std::unique_ptr<boxplus::LinearSolver> make_engine_solver(
    const EngineSettings& settings, const boxplus::LinearSolverOptions& options) {
  auto solver = boxplus::make_linear_solver(engine_kind(settings.solver), options);
  if (!settings.indefinite) return solver;
  return std::make_unique<PivotingSolver>(std::move(solver));
}

inline boxplus::AnalyzeHints analyze_hints(std::uint32_t eliminated_blocks = 0) {
  return {.threads = boxplus::detail::hardware_threads(), .eliminated_blocks = eliminated_blocks};
}

/// The tolerance and the maximum number of iterations for a right-hand side b with n values.
inline boxplus::SolveControl solve_control(const EngineSettings& settings, const double* b, std::size_t n) {
  double tolerance = settings.tolerance;
  if (settings.absoluteTolerance) {
    const double norm = Eigen::Map<const VectorX>(b, static_cast<Eigen::Index>(n)).norm();
    if (norm > 0 && norm < 1) tolerance /= norm;
  }
  return {.relative_tolerance = tolerance, .max_iterations = settings.maxIterations};
}

}  // namespace internal
}  // namespace g2o
