// SPDX-License-Identifier: BSD-3-Clause
// The table of all linear solvers. To add a solver to the library, add a line to the table.
#include "boxplus/linear/linear_solver_table.h"

#include <string>

#include "boxplus/base/error.h"
#include "linear/automatic/automatic_solver.h"
#include "linear/block_cholesky/block_cholesky.h"
#include "linear/dense/dense_solver.h"
#include "linear/eigen_sparse/eigen_sparse_solver.h"
#include "linear/pcg/pcg.h"

namespace boxplus {
namespace {

template <class S>
std::unique_ptr<LinearSolver> make(const LinearSolverOptions&) {
  return std::make_unique<S>();
}

std::unique_ptr<LinearSolver> make_automatic(const LinearSolverOptions& options) {
  return std::make_unique<AutomaticSolver>(options);
}

std::unique_ptr<LinearSolver> make_block_cholesky(const LinearSolverOptions& options) {
  return std::make_unique<BlockCholesky>(options.block_cholesky);
}

using Method = detail::LinearSolverEntry::Method;

constexpr detail::LinearSolverEntry kLinearSolvers[] = {
    {LinearSolverKind::kAutomatic, "automatic", make_automatic, Method::kDelegates},
    {LinearSolverKind::kBlockCholesky, "block_cholesky", make_block_cholesky, Method::kDirect},
    {LinearSolverKind::kPcg, "pcg", make<Pcg>, Method::kIterative},
    {LinearSolverKind::kDense, "dense", make<DenseSolver>, Method::kDirect},
    {LinearSolverKind::kEigenSparse, "eigen_sparse", make<EigenSparseSolver>, Method::kDirect, true},
};

}  // namespace

std::span<const detail::LinearSolverEntry> detail::linear_solver_table() {
  return kLinearSolvers;
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, const LinearSolverOptions& options) {
  for (const detail::LinearSolverEntry& entry : kLinearSolvers) {
    if (entry.kind == kind) return entry.make(options);
  }
  throw InvalidArgument(
      "make_linear_solver: expected one of the solvers of the library, got LinearSolverKind " +
      std::to_string(static_cast<int>(kind)));
}

std::string_view to_string(LinearSolverKind kind) {
  for (const detail::LinearSolverEntry& entry : kLinearSolvers) {
    if (entry.kind == kind) return entry.name;
  }
  return "unknown";
}

LinearSolverOptions for_newton_steps(LinearSolverOptions options) {
  // The tolerance of the block Cholesky in mixed precision. Newton's method squares its error in each step,
  // so this tolerance is as good as an exact solution, but it needs only half as much refinement.
  constexpr double kRefined = 1e-6;
  // The tolerance of pcg. On large maps, this tolerance takes far fewer iterations than an exact step.
  constexpr double kRough = 0.1;
  options.block_cholesky.min_tolerance = kRefined;
  options.automatic.min_tolerance = kRough;
  return options;
}

}  // namespace boxplus
