// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "solvers/register_solvers.h"

// These symbols let programs with G2O_USE_OPTIMIZATION_LIBRARY(cholmod) or
// G2O_USE_OPTIMIZATION_LIBRARY(csparse) link without the libraries solver_cholmod and solver_csparse. The
// factory then uses the algorithms of this library, which have the same linear solver.
extern "C" __attribute__((weak)) void G2O_OAF_EXPORT g2o_optimization_library_cholmod(void) {}
extern "C" __attribute__((weak)) void G2O_OAF_EXPORT g2o_optimization_library_csparse(void) {}

namespace g2o {

G2O_REGISTER_OPTIMIZATION_LIBRARY(eigen)
G2O_REGISTER_GN_AND_LM(LinearSolverEigen, "sparse Cholesky", var, fix3_2, fix6_3, fix7_3)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var,
    (internal::solver_creator<OptimizationAlgorithmDogleg, LinearSolverEigen, -1, -1>("dl_var", "Dogleg",
                                                                                      "sparse Cholesky")))

}  // namespace g2o
