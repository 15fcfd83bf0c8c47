// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/register_solvers.h"
#include "solvers/suitesparse/csparse_factor.h"

namespace g2o {
namespace internal {

template <class MatrixType>
using CSparseSolver = SparseFactorSolver<MatrixType, CSparseFactor>;

}  // namespace internal

G2O_REGISTER_OPTIMIZATION_LIBRARY(suitesparse_csparse)
G2O_REGISTER_GN_AND_LM(internal::CSparseSolver, "CSparse of SuiteSparse", var_suitesparse_csparse,
                       fix3_2_suitesparse_csparse, fix6_3_suitesparse_csparse, fix7_3_suitesparse_csparse)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_suitesparse_csparse,
    (internal::solver_creator<OptimizationAlgorithmDogleg, internal::CSparseSolver, -1, -1>(
        "dl_var_suitesparse_csparse", "Dogleg", "CSparse of SuiteSparse")))

}  // namespace g2o
