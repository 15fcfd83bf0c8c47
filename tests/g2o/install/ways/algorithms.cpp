// SPDX-License-Identifier: BSD-3-Clause
// algorithms NAME: constructs lm_var_cholmod and checks that the factory returns the algorithm NAME. This is
// lm_var if the library of lm_var_cholmod is not linked.
#include "g2o/core/optimization_algorithm_factory.h"

#if G2O_HAVE_CHOLMOD
G2O_USE_OPTIMIZATION_LIBRARY(cholmod)
#endif
#if G2O_HAVE_CSPARSE
G2O_USE_OPTIMIZATION_LIBRARY(csparse)
#endif

int main(int argc, char** argv) {
  g2o::OptimizationAlgorithmProperty property;
  g2o::OptimizationAlgorithm* algorithm =
      g2o::OptimizationAlgorithmFactory::instance()->construct("lm_var_cholmod", property);
  if (algorithm == nullptr) return 1;
  delete algorithm;
  std::cout << property.name << std::endl;
  return argc == 2 && property.name == argv[1] ? 0 : 2;
}
