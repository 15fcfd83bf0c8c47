// SPDX-License-Identifier: BSD-3-Clause
// A view of the graph for initial guesses: poses, points and the measurements between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/paced_stop.h"
#include "graph/graph_view.h"
#include "plan/plan.h"

namespace boxplus::guess {

/// The number of a vertex (GraphView).
using Node = std::uint32_t;

/// The number of measurements or frames that a loop processes between two checks of the stop token.
inline constexpr std::int64_t kBetweenStops = 256;

/// A relative measurement T_to ≈ T_from · motion. A point counts as a frame with the axes of the world. The
/// motion is not stored, because the edge can compute it again when it is needed.
struct Measurement {
  Node from, to;              ///< `from` may be FrameGraph::kWorld
  std::uint32_t pool, edge;   ///< the edge of the measurement
  bool has_rotation;          ///< whether the edge measures the rotation of `to`, not only its position
  bool leads_forward;         ///< whether the frame of `to` follows from the frame of `from`
  bool leads_backward;        ///< whether the frame of `from` follows from the frame of `to`
  double rotation_weight;     ///< the mean information per squared radian
  double translation_weight;  ///< the mean information per squared meter
};

class FrameGraph {
 public:
  static constexpr Node kWorld = 0xFFFFFFFFu;

  /// Throws Stopped when the token is raised.
  FrameGraph(Graph& graph, const Plan& plan, const StopToken& stop = {});

  std::span<const Measurement> measurements() const { return measurements_; }
  detail::Frame motion(const Measurement& measurement) const;
  /// The indices of the measurements that touch a node. For kWorld, these are the measurements from the
  /// world.
  std::span<const std::uint32_t> touching(Node node) const;

  Node nodes() const { return view_.numbers(); }
  Node node(std::uint32_t pool, std::uint32_t slot) const { return view_.number(pool, slot); }
  /// Whether a measurement touches the node, so that the node takes part.
  bool used(Node node) const { return (flags_[node] & kUsed) != 0; }
  bool movable(Node node) const { return (flags_[node] & kMovable) != 0; }
  bool pose(Node node) const { return (flags_[node] & kPose) != 0; }
  const Graph& graph() const { return *graph_; }
  int dimension(Node node) const { return (flags_[node] & kPlanar) != 0 ? 2 : 3; }
  Id id(Node node) const;
  /// The vertices that take part and may move. Poses come before points, and both are sorted by id.
  std::vector<Node> movable_by_id(const StopToken& stop = {}) const;

  detail::Frame frame(Node node) const;
  void set_frame(Node node, const detail::Frame& frame);

 private:
  enum Flag : std::uint8_t { kSeen = 1, kUsed = 2, kMovable = 4, kPose = 8, kPoint = 16, kPlanar = 32 };

  void mark_movable(const Plan& plan);
  void read_edges(const Plan& plan, PacedStop& pace);
  void read_edge(std::uint32_t pool, std::uint32_t edge);
  bool look_at(Node node, int dimension);
  void list_touching(PacedStop& pace);

  Graph* graph_;
  GraphView view_;
  std::vector<std::uint8_t> flags_;
  std::vector<Measurement> measurements_;
  std::vector<std::uint32_t> touching_start_, touching_;  // for each node, and then for the world
};

}  // namespace boxplus::guess
