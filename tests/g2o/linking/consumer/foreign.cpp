// SPDX-License-Identifier: BSD-3-Clause
// Imitates another implementation of g2o: its classes have the same names, but different contents.
#include <cstdlib>

#define EXPORTED __attribute__((visibility("default")))

namespace g2o {

class EXPORTED Factory {
 public:
  static Factory* instance();
  int calls = 0;
};

Factory* Factory::instance() {
  static Factory factory;
  ++factory.calls;
  return &factory;
}

class EXPORTED OptimizationAlgorithmFactory {
 public:
  static OptimizationAlgorithmFactory* instance();
};

OptimizationAlgorithmFactory* OptimizationAlgorithmFactory::instance() {
  std::abort();
}

}  // namespace g2o

extern "C" EXPORTED int foreign_calls() {
  return g2o::Factory::instance()->calls;
}
