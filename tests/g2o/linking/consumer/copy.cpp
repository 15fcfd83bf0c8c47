// SPDX-License-Identifier: BSD-3-Clause
// A library that optimizes a graph. If the g2o API is linked statically, this library contains its own copy
// of the API.
#include <sstream>

#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/sparse_optimizer.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

extern "C" G2O_API_EXPORT const void* factory() {
  return g2o::Factory::instance();
}

/// Returns the final chi2, or -1 if the algorithm or a type is not registered.
extern "C" G2O_API_EXPORT double optimum() {
  std::istringstream file(
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 1 1\nVERTEX_SE2 2 2 2 2\nFIX 0\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 2 1.5 0 0.1 1 0 0 1 0 1\n");
  g2o::SparseOptimizer optimizer;
  g2o::OptimizationAlgorithmProperty property;
  optimizer.setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct("lm_var", property));
  if (optimizer.algorithm() == nullptr || !optimizer.load(file)) return -1;
  optimizer.initializeOptimization();
  optimizer.optimize(20);
  optimizer.computeActiveErrors();
  return optimizer.activeChi2();
}
