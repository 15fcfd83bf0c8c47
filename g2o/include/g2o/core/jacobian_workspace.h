// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_JACOBIAN_WORKSPACE_H
#define G2O_JACOBIAN_WORKSPACE_H
#define JACOBIAN_WORKSPACE_H  // the name in g2o, which clients test with #ifdef

#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/core/g2o_core_api.h"
#include "g2o/core/hyper_graph.h"

namespace g2o {

struct OptimizableGraph;

/// The memory into which edges write their Jacobians. There is a separate buffer for each vertex position of
/// an edge. All edges use the same buffers, so each edge overwrites the Jacobians of the previous edge.
class G2O_CORE_API JacobianWorkspace {
 public:
  using WorkspaceVector = std::vector<VectorX>;

  JacobianWorkspace();
  ~JacobianWorkspace();

  /// Allocates the memory that updateSize() requested.
  bool allocate();
  /// Requests memory for an edge, for all edges of a graph, or for `numVertices` Jacobians of `dimension`
  /// values each. If `reset` is true, drops earlier requests.
  void updateSize(const HyperGraph::Edge* e, bool reset = false);
  void updateSize(const OptimizableGraph& graph, bool reset = false);
  void updateSize(int numVertices, int dimension, bool reset = false);
  void setZero();

  double* workspaceForVertex(int vertexIndex) { return _workspace[static_cast<size_t>(vertexIndex)].data(); }

 protected:
  WorkspaceVector _workspace;
  int _maxNumVertices = -1;
  int _maxDimension = -1;
};

}  // namespace g2o

#endif  // G2O_JACOBIAN_WORKSPACE_H
