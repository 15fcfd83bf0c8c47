// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/pcg/linear_solver_pcg.h"
#include "solvers/register_solvers.h"

namespace g2o {

G2O_REGISTER_OPTIMIZATION_LIBRARY(pcg)
G2O_REGISTER_GN_AND_LM(LinearSolverPCG, "conjugate gradients", pcg, pcg3_2, pcg6_3, pcg7_3)

}  // namespace g2o
