// SPDX-License-Identifier: BSD-3-Clause
// Loads a graph, optimizes it with an algorithm of the factory, and saves it.
#include <iostream>
#include <sstream>

#include "g2o/config.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/sim3/types_seven_dof_expmap.h"
#include "g2o/types/slam2d/vertex_se2.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

namespace g2o {
class EdgeSE2;
}

int main() {
  std::istringstream file(
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 1 0.5\nFIX 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n");
  g2o::SparseOptimizer optimizer;
  g2o::OptimizationAlgorithmProperty property;
  optimizer.setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct("lm_var", property));
  if (optimizer.algorithm() == nullptr || !optimizer.load(file)) return 1;
  optimizer.initializeOptimization();
  if (optimizer.optimize(10) <= 0 || !optimizer.save(std::cout)) return 1;
  const auto* v = static_cast<g2o::VertexSE2*>(optimizer.vertex(1));
  if (g2o::VertexSim3Expmap().estimate().log().norm() != 0) return 1;
  return (v->estimate().toVector() - g2o::Vector3(1, 0, 0)).norm() < 1e-6 ? 0 : 1;
}
