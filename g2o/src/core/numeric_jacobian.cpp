// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "core/pushed_estimates.h"
#include "g2o/core/base_edge.h"

namespace g2o {
namespace internal {

// Central differences with the step δ have the truncation error δ² e‴/6 and the rounding error ε|e|/δ. The
// g2o document uses the step 1e-9. The step 1e-6 makes the rounding error a thousand times smaller, and its
// truncation error is still below the accuracy of any sensor.
void numericJacobian(OptimizableGraph::Edge& edge, OptimizableGraph::Vertex& vertex, double* jacobian) {
  constexpr double kStep = 1e-6;
  const auto rows = static_cast<size_t>(edge.dimension());
  const auto cols = static_cast<size_t>(vertex.dimension());
  thread_local std::vector<double> before, step;
  before.assign(edge.errorData(), edge.errorData() + rows);
  step.assign(cols, 0.0);
  const auto evaluate = [&](size_t column, double delta) {
    PushedEstimates<OptimizableGraph::Vertex> pushed(vertex);
    step[column] = delta;
    vertex.oplus(step.data());
    step[column] = 0;
    edge.computeError();
    pushed.restore();
  };
  for (size_t column = 0; column < cols; ++column, jacobian += rows) {
    evaluate(column, kStep);
    std::copy_n(edge.errorData(), rows, jacobian);
    evaluate(column, -kStep);
    for (size_t row = 0; row < rows; ++row)
      jacobian[row] = (jacobian[row] - edge.errorData()[row]) / (2 * kStep);
  }
  std::copy(before.begin(), before.end(), edge.errorData());
}

void roomForJacobians(OptimizableGraph::Edge& edge) {
  OptimizableGraph* graph = edge.graph();
  if (graph == nullptr) return;
  graph->jacobianWorkspace().updateSize(&edge);
  graph->jacobianWorkspace().allocate();
}

}  // namespace internal
}  // namespace g2o
