// SPDX-License-Identifier: BSD-3-Clause
// Covariances together with all vertices to which they are relative.
#pragma once

#include <span>
#include <vector>

#include "boxplus/covariance/covariance.h"

namespace boxplus {

class BatchSystem;
class CovarianceSystem;

struct ReferencedCovariance {
  Covariance covariance;
  /// The vertices of which at least a rigid motion was held (3 directions in the plane, 6 in space), or all
  /// directions: those of Covariance::held(), and poses with more parameters, such as BAL's cameras, whose
  /// other parameters are not held. At least one for each component whose place nothing else determines, in
  /// ascending order of their ids.
  std::vector<VertexRef> references = {};
};

/// The same as marginal_covariances().
ReferencedCovariance referenced_covariances(const Graph& graph, std::span<const VertexRef> vertices,
                                            const Options& options);

/// The covariances of `vertices`, computed by a system that the caller keeps. `planned` is the argument of
/// CovarianceSystem::plan(). With `joint`, all cross-covariances are computed.
ReferencedCovariance covariance_of_system(CovarianceSystem& system, const Graph& graph,
                                          const Options& options, const BatchSystem* planned,
                                          std::span<const VertexRef> vertices, bool joint);

}  // namespace boxplus
