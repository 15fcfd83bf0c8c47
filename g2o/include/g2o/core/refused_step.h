// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_REFUSED_STEP_H_
#define G2O_REFUSED_STEP_H_

#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// For oplusImpl() of a vertex whose estimate cannot take a step, because the result would not be finite: the
/// estimate stays, the log names the vertex, and the algorithm takes the step back or stops.
G2O_CORE_API void refuseStep(const OptimizableGraph::Vertex& v);

}  // namespace internal
}  // namespace g2o

#endif  // G2O_REFUSED_STEP_H_
