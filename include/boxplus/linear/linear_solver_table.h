// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of the library, in one table.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "boxplus/linear/make_linear_solver.h"

namespace boxplus::detail {

struct LinearSolverEntry {
  LinearSolverKind kind;
  std::string_view name;    ///< in reports: "block_cholesky"
  std::string_view option;  ///< for command lines: "cholesky"
  std::unique_ptr<LinearSolver> (*make)(const LinearSolverOptions& options);
};

/// One entry per LinearSolverKind, in the order of help texts.
std::span<const LinearSolverEntry> linear_solver_table();

}  // namespace boxplus::detail
