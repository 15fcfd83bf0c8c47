// SPDX-License-Identifier: BSD-3-Clause
// Functions over a graph, called before and after iterations.
#pragma once

#include <set>

#include "g2o/core/hyper_graph.h"

namespace g2o {

/// Called with a graph; returns itself where it succeeded, else nullptr.
class G2O_CORE_API HyperGraphAction {
 public:
  class G2O_CORE_API Parameters {
   public:
    virtual ~Parameters();
  };
  class G2O_CORE_API ParametersIteration : public Parameters {
   public:
    explicit ParametersIteration(int iter);
    ~ParametersIteration() override;
    int iteration;
  };

  virtual ~HyperGraphAction();
  virtual HyperGraphAction* operator()(const HyperGraph* graph, Parameters* parameters = nullptr);
};

using HyperGraphActionSet = std::set<HyperGraphAction*>;

}  // namespace g2o
