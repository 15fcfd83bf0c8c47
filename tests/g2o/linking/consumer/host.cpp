// SPDX-License-Identifier: BSD-3-Clause
// host MODULE: checks that the types, actions and algorithms of this program stay registered while a module
// with another copy of the g2o API is loaded, and after the module is unloaded.
#include <dlfcn.h>

#include <cstdio>
#include <memory>

#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/optimization_algorithm_factory.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

static bool all_there() {
  g2o::OptimizationAlgorithmProperty property;
  const std::unique_ptr<g2o::OptimizationAlgorithm> algorithm(
      g2o::OptimizationAlgorithmFactory::instance()->construct("lm_var", property));
  const std::unique_ptr<g2o::HyperGraph::HyperGraphElement> vertex(
      g2o::Factory::instance()->construct("VERTEX_SE2"));
  auto* draw = g2o::HyperGraphActionLibrary::instance()->actionByName("draw");
  auto* draws = dynamic_cast<g2o::HyperGraphElementActionCollection*>(draw);
  return algorithm != nullptr && vertex != nullptr && draws != nullptr && !draws->actionMap().empty();
}

int main(int count, char** words) {
  if (count != 2 || !all_there()) return 1;
  for (int time = 0; time < 2; ++time) {
    void* module = dlopen(words[1], RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      std::fprintf(stderr, "%s\n", dlerror());
      return 1;
    }
    const auto optimum = reinterpret_cast<double (*)()>(dlsym(module, "optimum"));
    if (optimum() <= 0 || !all_there()) return 2;
    dlclose(module);
    if (!all_there()) return 3;
  }
  return 0;
}
