// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of PETSc, which the command loads at run time.
#pragma once

#include <memory>
#include <string>

#include "boxplus/linear/linear_solver.h"

namespace boxplus::app {

/// A function of the plug-in (plugins/petsc/src/plugin.cpp). Throws InvalidArgument, which says how to get
/// the plug-in, if it is not installed.
void* find_in_petsc_plugin(const char* function);

/// make_petsc_solver() of the plug-in.
std::shared_ptr<LinearSolver> load_petsc_solver(const std::string& options);

}  // namespace boxplus::app
