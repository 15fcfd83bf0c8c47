// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/csparse/csparse_factor.h"
#include "solvers/register_solvers.h"

namespace g2o {
namespace internal {

template <class MatrixType>
using CSparseSolver = SparseFactorSolver<MatrixType, CSparseFactor>;

}  // namespace internal

G2O_REGISTER_OPTIMIZATION_LIBRARY(csparse)
G2O_REGISTER_GN_AND_LM(internal::CSparseSolver, "CSparse", var_csparse, fix3_2_csparse, fix6_3_csparse,
                       fix7_3_csparse)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(
    dl_var_csparse, (internal::solver_creator<OptimizationAlgorithmDogleg, internal::CSparseSolver, -1, -1>(
                        "dl_var_csparse", "Dogleg", "CSparse")))

}  // namespace g2o
