// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of PETSc, for Options::custom_linear_solver. Programs link boxplus::petsc.
#pragma once

#include <memory>
#include <string>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// Solves with a Krylov method (KSP) and a preconditioner (PC) of PETSc, in this process. `options` are those
/// of PETSc's command line, such as "-ksp_type cg -pc_type gamg". They do not change PETSc's own database of
/// options, whose entries do not apply to this solver.
///
/// The defaults depend on what the options leave open:
/// - without a method and a preconditioner, or with only "-ksp_type preonly": the Cholesky factorization of
///   MUMPS (of PETSc, if it was built without MUMPS);
/// - otherwise: cg, and point-block Jacobi.
///
/// Blocks of equal sizes become a block matrix: BAIJ, or SBAIJ for MUMPS. Other blocks become an AIJ matrix
/// that knows their sizes, so that its point-block Jacobi is vpbjacobi. The Cholesky factorization of PETSc
/// itself gets an AIJ matrix. "-mat_type" changes this; gamg, for example, needs "-mat_type aij".
///
/// Iterative methods solve to SolveControl::relative_tolerance, which is checked with the residual b − (A +
/// λD) x and not with PETSc's norm, unless the options contain "-ksp_rtol". If the method is preonly, and the
/// residual is not small enough, the solution is refined.
///
/// Deviates from the contract of LinearSolver: PETSc allocates memory in each call, MUMPS cannot be stopped
/// during a factorization, and negative pivots have no name unless they are on the diagonal of A + λD.
/// selected_inverse() returns false.
///
/// PETSc starts in the first call, and ends when the program exits, unless the program has started PETSc or
/// MPI itself. Then the program must not end them before it destroys its solvers. Any thread may call
/// solvers, and calls wait for each other, because PETSc is not thread-safe.
///
/// Throws InvalidArgument if PETSc refuses the options; the first solve() does so if it used not all of them.
std::unique_ptr<LinearSolver> make_petsc_solver(const std::string& options = {});

}  // namespace boxplus
