// SPDX-License-Identifier: BSD-3-Clause
// The class Covariance of Python.
#pragma once

#include "boxplus/covariance/covariance.h"
#include "graph_object.h"

namespace boxplus::python {

/// A covariance, and its graph, so that vertices can be named by their ids.
struct CovarianceObject {
  Covariance covariance;
  const py::object graph;

  VertexRef vertex(py::handle vertex, const char* name) const {
    return vertex_of(graph.cast<const GraphObject&>().read(), vertex, name);
  }
  template <class Function>
  void for_each_reference(const Function& f) {
    f(graph);
  }
};

}  // namespace boxplus::python
