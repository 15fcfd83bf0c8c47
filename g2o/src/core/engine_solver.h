// SPDX-License-Identifier: BSD-3-Clause
// The engine's linear solvers by the names of the face.
#pragma once

#include "boxplus/base/parallel.h"
#include "boxplus/linear/linear_solver.h"
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

inline boxplus::AnalyzeHints analyze_hints(const EngineSettings& settings) {
  boxplus::AnalyzeHints hints;
  if (settings.exact) hints.precision = boxplus::Precision::kDouble;
  hints.threads = boxplus::hardware_threads();
  return hints;
}

/// Enough for a step of Newton's method.
inline constexpr double kStepTolerance = 1e-6;

/// How exactly to solve for the right-hand side b of n numbers.
inline boxplus::SolveControl solve_control(const EngineSettings& settings, const double* b, std::size_t n) {
  double tolerance = settings.tolerance;
  if (settings.absoluteTolerance) {
    const double norm = Eigen::Map<const VectorX>(b, static_cast<Eigen::Index>(n)).norm();
    if (norm > 0 && norm < 1) tolerance /= norm;
  }
  return {tolerance, settings.maxIterations};
}

}  // namespace internal
}  // namespace g2o
