// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/cholmod/cholmod_factor.h"
#include "solvers/register_solvers.h"

namespace g2o {
namespace internal {

template <class MatrixType>
using CholmodSolver = SparseFactorSolver<MatrixType, CholmodFactor>;

}  // namespace internal

G2O_REGISTER_OPTIMIZATION_LIBRARY(cholmod)
G2O_REGISTER_GN_AND_LM(internal::CholmodSolver, "CHOLMOD", var_cholmod, fix3_2_cholmod, fix6_3_cholmod,
                       fix7_3_cholmod)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_cholmod, (internal::solver_creator<OptimizationAlgorithmDogleg, internal::CholmodSolver, -1, -1>(
                        "dl_var_cholmod", "Dogleg", "CHOLMOD")))

}  // namespace g2o
