// SPDX-License-Identifier: BSD-3-Clause
#include "engine/measured_solver.h"

#include "engine/engine_solver.h"
#include "g2o/core/batch_stats.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {
namespace internal {
namespace {

/// Returns a pointer to a field of the current statistics, or nullptr if no statistics are collected.
double* counted(double G2OBatchStatistics::*field) {
  G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats();
  return statistics == nullptr ? nullptr : &(statistics->*field);
}

}  // namespace

void MeasuredSolver::analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints& hints,
                             const boxplus::StopToken& stop) {
  const AddedTime time(counted(&G2OBatchStatistics::timeSymbolicDecomposition));
  scalars_ = structure.scalars();
  solver_->analyze(structure, hints, stop);
}

boxplus::FactorResult MeasuredSolver::factorize(const boxplus::BlockSystem& system,
                                                const boxplus::Damping& damping,
                                                const boxplus::SolveControl& control) {
  const AddedTime own(&factorize_seconds_);
  const AddedTime time(counted(&G2OBatchStatistics::timeNumericDecomposition));
  const AddedTime solver_time(counted(&G2OBatchStatistics::timeLinearSolver));
  return solver_->factorize(system, damping, control);
}

boxplus::SolveResult MeasuredSolver::solve(const double* b, int columns, double* x,
                                           const boxplus::SolveControl& control) {
  const AddedTime time(counted(&G2OBatchStatistics::timeLinearSolver));
  boxplus::SolveControl adapted = solve_control(settings_, b, scalars_);
  adapted.stop = control.stop;
  return solver_->solve(b, columns, x, adapted);
}

}  // namespace internal
}  // namespace g2o
