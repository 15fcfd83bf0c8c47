// SPDX-License-Identifier: BSD-3-Clause
// The action "writeGnuplot" of the ready-made types: a vertex is a line, an edge two lines and an empty one.
#pragma once

#include <ostream>

#include "g2o/core/hyper_graph_action.h"

namespace g2o {
namespace internal {

/// `Write` is called with the element and the stream.
template <class T, class Write>
class GnuplotAction : public WriteGnuplotAction {
 public:
  GnuplotAction() : WriteGnuplotAction(typeid(T).name()) {}

  using WriteGnuplotAction::operator();
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    auto* typed = static_cast<WriteGnuplotAction::Parameters*>(parameters);
    if (typeid(*element).name() != _typeName || typed == nullptr || typed->os == nullptr) return nullptr;
    Write()(*static_cast<const T*>(element), *typed->os);
    return this;
  }
};

}  // namespace internal
}  // namespace g2o
