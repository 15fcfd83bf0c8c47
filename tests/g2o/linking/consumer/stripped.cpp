// SPDX-License-Identifier: BSD-3-Clause
// Constructs types by their tags and an algorithm by its name, without a reference to their classes.
#include <cstdio>
#include <sstream>

#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/sparse_optimizer.h"

G2O_USE_TYPE_GROUP(custom)
G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

int main() {
  std::istringstream file(
      "CUSTOM_NUMBER 0 9\nCUSTOM:WEIGHED 0 2 1\nCUSTOM:WEIGHED 0 4 1\n"
      "VERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 1 1 1\nFIX 1\nEDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n");
  g2o::SparseOptimizer optimizer;
  g2o::OptimizationAlgorithmProperty property;
  optimizer.setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct("gn_var", property));
  if (optimizer.algorithm() == nullptr || !optimizer.load(file) || optimizer.edges().size() != 3) return 1;
  if (!optimizer.initializeOptimization() || optimizer.optimize(5) != 5) return 2;
  optimizer.computeActiveErrors();
  std::printf("chi2 %.6f\n", optimizer.activeChi2());
  return optimizer.activeChi2() > 1.999 && optimizer.activeChi2() < 2.001 ? 0 : 3;
}
