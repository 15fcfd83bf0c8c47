// SPDX-License-Identifier: BSD-3-Clause
// The role of an edge in a trajectory: odometry, loop closure, observation …
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

enum class VertexRole : std::uint8_t { kPose, kLandmark, kOther };
VertexRole role_of(const Graph& graph, VertexRef vertex);

enum class EdgeRole : std::uint8_t {
  kOdometry,     ///< between consecutive poses by id (landmarks in between are ignored)
  kLoopClosure,  ///< between other poses
  kObservation,  ///< of a landmark
  kPrior,        ///< of one vertex
  kOther
};
inline constexpr std::size_t kEdgeRoles = 5;

/// "loop closure", "loop closures" …
std::string_view name_of(EdgeRole role, std::size_t count);

/// Finds the roles of edges. The structure of the graph must not change meanwhile. O(n log n).
class EdgeRoles {
 public:
  explicit EdgeRoles(const Graph& graph);
  EdgeRole operator()(EdgeRef edge) const;

 private:
  const Graph* graph_;
  std::unordered_map<Id, std::size_t> rank_;  ///< the rank of each pose when poses are sorted by id
};

}  // namespace boxplus::app
