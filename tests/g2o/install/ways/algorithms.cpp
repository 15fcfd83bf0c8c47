// SPDX-License-Identifier: BSD-3-Clause
// algorithms NAME: runs lm_var_cholmod on a small graph, and checks that the factory constructs the algorithm
// NAME for it. This is lm_var if only the library solver_eigen is linked. No library of SuiteSparse except
// for the orderings AMD and CAMD may be in the process.
#include <fstream>

#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/slam2d/types_slam2d.h"

#if G2O_HAVE_CHOLMOD
G2O_USE_OPTIMIZATION_LIBRARY(cholmod)
#endif
#if G2O_HAVE_CSPARSE
G2O_USE_OPTIMIZATION_LIBRARY(csparse)
#endif

namespace {

bool optimizes(g2o::OptimizationAlgorithm* algorithm) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(algorithm);
  for (int id = 0; id < 2; ++id) {
    g2o::VertexSE2* v = new g2o::VertexSE2;
    v->setId(id);
    v->setFixed(id == 0);
    optimizer.addVertex(v);
  }
  g2o::EdgeSE2* e = new g2o::EdgeSE2;
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  e->setMeasurement(g2o::SE2(1, 2, 0.5));
  optimizer.addEdge(e);
  optimizer.initializeOptimization();
  const g2o::VertexSE2* moved = static_cast<g2o::VertexSE2*>(optimizer.vertex(1));
  return optimizer.optimize(10) > 0 && std::abs(moved->estimate()[1] - 2) < 1e-6;
}

bool has_foreign_libraries() {
  std::ifstream maps("/proc/self/maps");
  bool found = false;
  for (std::string line; std::getline(maps, line);) {
    for (const char* library :
         {"libcholmod", "libcxsparse", "libcolamd", "libccolamd", "libmetis", "libblas", "liblapack"}) {
      if (line.find(library) == std::string::npos) continue;
      std::cerr << line << std::endl;
      found = true;
    }
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  g2o::OptimizationAlgorithmProperty property;
  g2o::OptimizationAlgorithm* algorithm =
      g2o::OptimizationAlgorithmFactory::instance()->construct("lm_var_cholmod", property);
  if (algorithm == nullptr) return 1;
  std::cout << property.name << std::endl;
  if (argc != 2 || property.name != argv[1]) return 2;
  if (!optimizes(algorithm)) return 3;
  return has_foreign_libraries() ? 4 : 0;
}
