// SPDX-License-Identifier: BSD-3-Clause
// Lists the rows of the table of linear solvers, so that tests of all solvers also run on a new solver.
#pragma once

#include <vector>

#include "boxplus/linear/linear_solver_table.h"

namespace boxplus {

/// All solvers except kAutomatic, which only chooses another solver.
inline std::vector<detail::LinearSolverEntry> every_solver() {
  std::vector<detail::LinearSolverEntry> solvers;
  for (const detail::LinearSolverEntry& entry : detail::linear_solver_table()) {
    if (entry.method != detail::LinearSolverEntry::Method::kDelegates) solvers.push_back(entry);
  }
  return solvers;
}

inline std::vector<LinearSolverKind> every_direct_solver() {
  std::vector<LinearSolverKind> kinds;
  for (const detail::LinearSolverEntry& entry : every_solver()) {
    if (entry.method == detail::LinearSolverEntry::Method::kDirect) kinds.push_back(entry.kind);
  }
  return kinds;
}

}  // namespace boxplus
