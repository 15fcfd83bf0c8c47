// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm.h"

#include <ostream>

namespace g2o {

OptimizationAlgorithm::OptimizationAlgorithm() = default;
OptimizationAlgorithm::~OptimizationAlgorithm() = default;

bool OptimizationAlgorithm::updatePropertiesFromString(const std::string& propString) {
  return _properties.updateMapFromString(propString);
}

void OptimizationAlgorithm::printProperties(std::ostream& os) const {
  os << "------------- Algorithm Properties -------------\n";
  for (const auto& [name, property] : _properties) os << name << "\t" << property->toString() << "\n";
  os << "------------------------------------------------\n";
}

}  // namespace g2o
