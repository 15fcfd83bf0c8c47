// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/jacobian_workspace.h"

#include <algorithm>

#include "g2o/core/optimizable_graph.h"

namespace g2o {

JacobianWorkspace::JacobianWorkspace() = default;
JacobianWorkspace::~JacobianWorkspace() = default;

bool JacobianWorkspace::allocate() {
  if (_maxNumVertices <= 0 || _maxDimension <= 0) return false;
  _workspace.resize(std::max(_workspace.size(), static_cast<size_t>(_maxNumVertices)));
  for (VectorX& part : _workspace) {
    if (part.size() < _maxDimension) part.setZero(_maxDimension);
  }
  return true;
}

void JacobianWorkspace::updateSize(const HyperGraph::Edge* e_, bool reset) {
  const auto* e = static_cast<const OptimizableGraph::Edge*>(e_);
  int largest = -1;
  for (const HyperGraph::Vertex* v : e->vertices()) {
    if (v != nullptr)
      largest = std::max(largest, static_cast<const OptimizableGraph::Vertex*>(v)->dimension());
  }
  updateSize(static_cast<int>(e->vertices().size()), largest * e->dimension(), reset);
}

void JacobianWorkspace::updateSize(const OptimizableGraph& graph, bool reset) {
  if (reset) updateSize(-1, -1, true);
  for (const HyperGraph::Edge* e : graph.edges()) updateSize(e);
}

void JacobianWorkspace::updateSize(int numVertices, int dimension, bool reset) {
  _maxNumVertices = reset ? numVertices : std::max(_maxNumVertices, numVertices);
  _maxDimension = reset ? dimension : std::max(_maxDimension, dimension);
}

void JacobianWorkspace::setZero() {
  for (VectorX& part : _workspace) part.setZero();
}

}  // namespace g2o
