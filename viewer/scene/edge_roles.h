// SPDX-License-Identifier: BSD-3-Clause
// The roles of edges in a trajectory: odometry, loop closure, observation …
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "boxplus/graph/graph.h"

namespace boxplus::viewer {

enum class VertexRole : std::uint8_t { kPose, kLandmark, kOther };
VertexRole role_of(const Graph& graph, VertexRef vertex);

enum class EdgeRole : std::uint8_t {
  kOdometry,     ///< an edge between poses whose ids are next to each other among the ids of all poses
  kLoopClosure,  ///< an edge between other poses
  kObservation,  ///< an edge with a landmark, or of one pose with something else, such as a plane
  kPrior,        ///< an edge with only one vertex
  kOther
};
inline constexpr std::size_t kEdgeRoles = 5;

/// Returns the name of a role for `count` edges, such as "loop closure" or "loop closures".
std::string_view name_of(EdgeRole role, std::size_t count);

/// Finds the roles of edges. While an EdgeRoles exists, the structure of its graph must not change. The
/// constructor takes O(n log n) time.
class EdgeRoles {
 public:
  explicit EdgeRoles(const Graph& graph);
  EdgeRole operator()(EdgeRef edge) const;

 private:
  const Graph* graph_;
  /// The position of each pose of the trajectory in the list sorted by id. A pose that is always the last of
  /// three or more vertices is that of a sensor on the robot.
  std::unordered_map<Id, std::size_t> rank_;
};

}  // namespace boxplus::viewer
