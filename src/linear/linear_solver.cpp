// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/linear_solver.h"

#include "boxplus/base/error.h"
#include "linear/automatic/automatic_solver.h"
#include "linear/block_cholesky/block_cholesky.h"
#include "linear/dense/dense_solver.h"
#include "linear/eigen_sparse/eigen_sparse_solver.h"
#include "linear/pcg/pcg.h"

namespace boxplus {

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind) {
  switch (kind) {
    case LinearSolverKind::kAutomatic:
      return std::make_unique<AutomaticSolver>();
    case LinearSolverKind::kBlockCholesky:
      return std::make_unique<BlockCholesky>();
    case LinearSolverKind::kDense:
      return std::make_unique<DenseSolver>();
    case LinearSolverKind::kPcg:
      return std::make_unique<Pcg>();
    case LinearSolverKind::kEigenSparse:
      return std::make_unique<EigenSparseSolver>();
  }
  throw InvalidArgument("make_linear_solver: unknown kind");
}

std::string_view to_string(Precision precision) {
  switch (precision) {
    case Precision::kAutomatic:
      return "automatic";
    case Precision::kDouble:
      return "double";
    case Precision::kMixed:
      return "mixed";
  }
  return "unknown";
}

std::string_view to_string(LinearSolverKind kind) {
  switch (kind) {
    case LinearSolverKind::kAutomatic:
      return "automatic";
    case LinearSolverKind::kBlockCholesky:
      return "block_cholesky";
    case LinearSolverKind::kPcg:
      return "pcg";
    case LinearSolverKind::kDense:
      return "dense";
    case LinearSolverKind::kEigenSparse:
      return "eigen_sparse";
  }
  return "unknown";
}

}  // namespace boxplus
