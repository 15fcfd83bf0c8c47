// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of the library and their options.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

enum class LinearSolverKind : std::uint8_t {
  kAutomatic,  ///< the block Cholesky, or pcg if AutomaticSolverOptions says so
  kBlockCholesky,
  kPcg,
  kDense,
  kEigenSparse
};
std::string_view to_string(LinearSolverKind kind);

struct BlockCholeskyOptions {
  Ordering ordering = Ordering::kAutomatic;
  Precision precision = Precision::kAutomatic;
  /// Solutions by a factor in float are refined to SolveControl::relative_tolerance, or to this if it is
  /// larger.
  double least_tolerance = 0;
};

/// When kAutomatic takes pcg rather than the block Cholesky: if the factor is predicted not to fit into
/// memory, or a factorization to take several times as long as a rough solution by pcg.
struct AutomaticSolverOptions {
  std::uint64_t max_factor_bytes = 0;  ///< the most memory for a factor; 0: half of the machine's
  /// Pcg then solves to SolveControl::relative_tolerance, or to this if it is larger.
  double least_tolerance = 0;
};

/// Those of all kinds; each solver reads its own.
struct LinearSolverOptions {
  BlockCholeskyOptions block_cholesky = {};
  AutomaticSolverOptions automatic = {};
};

/// The same options, with solutions only as exact as steps of Newton's method can use.
LinearSolverOptions for_newton_steps(LinearSolverOptions options);

/// Throws InvalidArgument if there is no such kind.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const LinearSolverOptions& options = {});

/// How the Schur complement of eliminated blocks is used.
enum class SchurMode : std::uint8_t {
  kAutomatic,  ///< explicit for solvers that need blocks, implicit for those that need only products
  kExplicit,
  kImplicit
};

/// A solver that eliminates the blocks that AnalyzeHints::eliminated_blocks says by the Schur complement, and
/// lets `inner`, by whose name it goes, solve for the others. If there are none, or no others, it is `inner`
/// and no more.
std::shared_ptr<LinearSolver> make_schur_solver(std::shared_ptr<LinearSolver> inner,
                                                SchurMode mode = SchurMode::kAutomatic);

}  // namespace boxplus
