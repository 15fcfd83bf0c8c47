// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
#include "solvers/register_solvers.h"

namespace g2o {

G2O_REGISTER_OPTIMIZATION_LIBRARY(cholmod)
G2O_REGISTER_GN_AND_LM(LinearSolverCholmod, "sparse Cholesky", var_cholmod, fix3_2_cholmod, fix6_3_cholmod,
                       fix7_3_cholmod)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_cholmod, (internal::solver_creator<OptimizationAlgorithmDogleg, LinearSolverCholmod, -1, -1>(
                        "dl_var_cholmod", "Dogleg", "sparse Cholesky")))

}  // namespace g2o
