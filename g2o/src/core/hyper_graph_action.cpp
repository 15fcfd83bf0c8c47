// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/hyper_graph_action.h"

namespace g2o {

HyperGraphAction::Parameters::~Parameters() = default;
HyperGraphAction::ParametersIteration::ParametersIteration(int iter) : iteration(iter) {}
HyperGraphAction::ParametersIteration::~ParametersIteration() = default;
HyperGraphAction::~HyperGraphAction() = default;

HyperGraphAction* HyperGraphAction::operator()(const HyperGraph*, Parameters*) {
  return nullptr;
}

}  // namespace g2o
