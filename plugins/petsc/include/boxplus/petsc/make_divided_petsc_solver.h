// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of PETSc for a DistributedOptimizer (boxplus/mpi/distributed_optimizer.h). Programs link
// boxplus::petsc and boxplus::mpi.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// As make_petsc_solver(), for Options::custom_linear_solver of a DistributedOptimizer with the same
/// communicator. No process has the whole system of the kept vertices: each has the rows of an equal number
/// of them, and what other processes contribute is added in the order of ranks. So their number is not
/// limited to DistributedOptimizer::kMostKept; but there must be at least one for each process.
///
/// With several processes, MUMPS, the default, may round differently in each run. Krylov methods with
/// point-block Jacobi have the same bits in each run.
///
/// Collective, as are all functions of the solver and its destructor. The program has started MPI, and must
/// destroy the solver before it ends MPI or frees the communicator.
std::unique_ptr<LinearSolver> make_divided_petsc_solver(MPI_Comm communicator,
                                                        const std::string& options = {});

}  // namespace boxplus
