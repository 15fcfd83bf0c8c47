// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "g2o/core/solver.h"
#include "g2o/core/sparse_optimizer.h"

namespace normal_equations {

/// b, the diagonal blocks of H, and the solution with the damping λ. The solution also depends on the
/// off-diagonal blocks of H. `solver` must be the solver of the optimizer's algorithm.
inline std::vector<double> of(g2o::SparseOptimizer& optimizer, g2o::Solver& solver, double lambda = 0) {
  optimizer.computeActiveErrors();
  solver.init(&optimizer);
  solver.buildStructure();
  solver.buildSystem();
  std::vector<double> values(solver.b(), solver.b() + solver.vectorSize());
  for (g2o::OptimizableGraph::Vertex* v : optimizer.indexMapping())
    values.insert(values.end(), v->hessianData(), v->hessianData() + v->dimension() * v->dimension());
  solver.setLambda(lambda);
  EXPECT_TRUE(solver.solve());
  values.insert(values.end(), solver.x(), solver.x() + solver.vectorSize());
  return values;
}

}  // namespace normal_equations
