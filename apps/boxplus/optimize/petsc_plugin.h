// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of PETSc, which the command loads at run time.
#pragma once

#include <memory>
#include <string>

#include "boxplus/linear/linear_solver.h"

namespace boxplus::app {

/// make_petsc_solver() of plugins/petsc. Throws InvalidArgument, which says how to get the plug-in, if it is
/// not installed.
std::shared_ptr<LinearSolver> load_petsc_solver(const std::string& options);

}  // namespace boxplus::app
