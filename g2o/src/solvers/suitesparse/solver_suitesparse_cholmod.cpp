// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/register_solvers.h"
#include "solvers/suitesparse/cholmod_factor.h"

namespace g2o {
namespace internal {

template <class MatrixType>
using CholmodSolver = SparseFactorSolver<MatrixType, CholmodFactor>;

}  // namespace internal

G2O_REGISTER_OPTIMIZATION_LIBRARY(suitesparse_cholmod)
G2O_REGISTER_GN_AND_LM(internal::CholmodSolver, "CHOLMOD of SuiteSparse", var_suitesparse_cholmod,
                       fix3_2_suitesparse_cholmod, fix6_3_suitesparse_cholmod, fix7_3_suitesparse_cholmod)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_suitesparse_cholmod,
    (internal::solver_creator<OptimizationAlgorithmDogleg, internal::CholmodSolver, -1, -1>(
        "dl_var_suitesparse_cholmod", "Dogleg", "CHOLMOD of SuiteSparse")))

}  // namespace g2o
