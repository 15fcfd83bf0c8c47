// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "solvers/register_solvers.h"

namespace g2o {

G2O_REGISTER_OPTIMIZATION_LIBRARY(dense)
G2O_REGISTER_GN_AND_LM(LinearSolverDense, "dense Cholesky", dense, dense3_2, dense6_3, dense7_3)

}  // namespace g2o
