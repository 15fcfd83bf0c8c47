// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of the library, in one table.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "boxplus/linear/make_linear_solver.h"

namespace boxplus::detail {

struct LinearSolverEntry {
  enum class Method : std::uint8_t {
    kDelegates,  ///< chooses another solver and calls it
    kDirect,     ///< factorizes, and reports every matrix that is not positive definite
    kIterative   ///< only approximates solutions, and has no selected inverse
  };

  LinearSolverKind kind;
  std::string_view name;  ///< in reports: "block_cholesky"
  std::unique_ptr<LinearSolver> (*make)(const LinearSolverOptions& options);
  Method method;
  bool allocates_in_every_call = false;  ///< instead of only in the first factorize() and solve()
};

/// One entry per LinearSolverKind, in the order of help texts.
std::span<const LinearSolverEntry> linear_solver_table();

}  // namespace boxplus::detail
