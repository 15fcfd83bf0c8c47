// SPDX-License-Identifier: BSD-3-Clause
// The class Covariance of Python.
#pragma once

#include <memory>

#include "boxplus/optimize/covariance.h"
#include "graph_object.h"

namespace boxplus::python {

/// A covariance, and its graph, so that vertices can be named by their ids.
struct CovarianceObject {
  Covariance covariance;
  std::shared_ptr<GraphObject> graph;

  VertexRef vertex(py::handle vertex, const char* name) const {
    return vertex_of(graph->read(), vertex, name);
  }
};

}  // namespace boxplus::python
