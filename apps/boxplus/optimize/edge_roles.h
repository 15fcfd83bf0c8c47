// SPDX-License-Identifier: BSD-3-Clause
// What an edge is to a robot: odometry, a loop closure, an observation …
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

enum class VertexRole : std::uint8_t { kPose, kLandmark, kOther };
VertexRole role_of(const Graph& graph, VertexRef vertex);

enum class EdgeRole : std::uint8_t {
  kOdometry,     ///< between poses that follow each other by id (landmarks in between do not count)
  kLoopClosure,  ///< between other poses
  kObservation,  ///< of a landmark
  kPrior,        ///< of one vertex
  kOther
};
inline constexpr std::size_t kEdgeRoles = 5;

/// "loop closure", "loop closures" …
std::string_view name_of(EdgeRole role, std::size_t count);

/// Tells the roles of the edges of a graph whose structure does not change meanwhile. O(n log n).
class EdgeRoles {
 public:
  explicit EdgeRoles(const Graph& graph);
  EdgeRole operator()(EdgeRef edge) const;

 private:
  const Graph* graph_;
  std::unordered_map<Id, std::size_t> rank_;  ///< of each pose among the poses by id
};

}  // namespace boxplus::app
