// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of the library and their options.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "boxplus/linear/linear_solver.h"
#include "boxplus/linear/linear_solver_kind.h"

namespace boxplus {

struct BlockCholeskyOptions {
  Ordering ordering = Ordering::kAutomatic;
  Precision precision = Precision::kAutomatic;
  /// If the factor is in float, solutions are refined to the larger of SolveControl::relative_tolerance and
  /// this tolerance.
  double min_tolerance = 0;
};

/// kAutomatic uses pcg instead of the block Cholesky in two cases: if the factor is predicted not to fit into
/// memory, or if a factorization is predicted to take several times as long as a rough solution by pcg.
struct AutomaticSolverOptions {
  std::uint64_t max_factor_bytes = 0;  ///< maximum memory of a factor; 0: half of the machine's memory
  /// In these cases, pcg solves to the larger of SolveControl::relative_tolerance and this tolerance.
  double min_tolerance = 0;
};

/// The options of all solvers; each solver reads its own.
struct LinearSolverOptions {
  BlockCholeskyOptions block_cholesky = {};
  AutomaticSolverOptions automatic = {};
};

/// Returns the same options, except that solutions are only as accurate as the steps of Newton's method need
/// to be.
LinearSolverOptions for_newton_steps(LinearSolverOptions options);

/// Throws InvalidArgument if there is no such kind.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const LinearSolverOptions& options = {});

/// A solver that eliminates the first AnalyzeHints::eliminated_blocks blocks by the Schur complement, and
/// lets `inner` solve for the other blocks. It has the name of `inner`. If no blocks, or all of them, are to
/// be eliminated, `inner` solves for all blocks.
std::shared_ptr<LinearSolver> make_schur_solver(std::shared_ptr<LinearSolver> inner,
                                                SchurMode mode = SchurMode::kAutomatic);

}  // namespace boxplus
