// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_REFUSED_STEP_H_
#define G2O_REFUSED_STEP_H_

#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// A vertex calls this function in oplusImpl() if the step would make its estimate infinite or NaN. The
/// vertex then does not change its estimate. The function logs a warning that names the first such vertex,
/// and the algorithm rejects the step or stops.
G2O_CORE_API void refuseStep(const OptimizableGraph::Vertex& v);

}  // namespace internal
}  // namespace g2o

#endif  // G2O_REFUSED_STEP_H_
