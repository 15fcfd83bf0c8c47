// SPDX-License-Identifier: BSD-3-Clause
// What programs that load the plug-in at run time find in it.
#include "boxplus/petsc/make_divided_petsc_solver.h"
#include "boxplus/petsc/make_petsc_solver.h"

/// make_petsc_solver() for programs of the same build. The caller owns the solver.
extern "C" [[gnu::visibility("default")]] boxplus::LinearSolver* boxplus_petsc_solver(const char* options) {
  return boxplus::make_petsc_solver(options).release();
}

/// make_divided_petsc_solver() for programs of the same build. The caller owns the solver.
extern "C" [[gnu::visibility("default")]] boxplus::LinearSolver* boxplus_divided_petsc_solver(
    MPI_Comm communicator, const char* options) {
  return boxplus::make_divided_petsc_solver(communicator, options).release();
}
