// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/csparse/linear_solver_csparse.h"
#include "solvers/register_solvers.h"

namespace g2o {

G2O_REGISTER_OPTIMIZATION_LIBRARY(csparse)
G2O_REGISTER_GN_AND_LM(LinearSolverCSparse, "sparse Cholesky", var_csparse, fix3_2_csparse, fix6_3_csparse,
                       fix7_3_csparse)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_csparse, (internal::solver_creator<OptimizationAlgorithmDogleg, LinearSolverCSparse, -1, -1>(
                        "dl_var_csparse", "Dogleg", "sparse Cholesky")))

}  // namespace g2o
