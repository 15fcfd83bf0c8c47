// SPDX-License-Identifier: BSD-3-Clause
// Finds the connected parts of a graph, and chooses roots for the parts that have no root.
#pragma once

#include <cstdint>
#include <vector>

#include "guess/frame_graph.h"

namespace boxplus::guess {

/// The connected parts of the movable vertices. Landmarks connect the poses that see them, but constant
/// vertices do not connect their neighbors.
///
/// A part has a root if one of its poses is measured relative to a constant pose or to the world, or if a
/// constant pose sees one of its points. Other absolute measurements (the position of a pose, or a point with
/// a known position) are not enough to start from, because they do not determine the orientation. If a part
/// has only such measurements, the guess starts at the part's pose with the lowest id. Afterwards, the part
/// is moved to fit the absolute measurements.
class Components {
 public:
  /// The constructor and align() throw Stopped when the token is raised. The token must outlive this object.
  explicit Components(const FrameGraph& frames, const StopToken& stop);

  /// For each part without a root, the vertex from which the guess starts. It is a point if the part has no
  /// poses, and otherwise a pose.
  const std::vector<Node>& free_roots() const { return free_roots_; }
  /// Whether the measurement is an absolute position in a part without a root. Only align() uses such a
  /// position.
  bool left_for_alignment(const Measurement& measurement) const;
  /// Moves each part without a root rigidly, so that it fits the absolute positions that were measured in it
  /// (Umeyama, "Least-squares estimation of transformation parameters between two point patterns", 1991).
  void align(FrameGraph& frames) const;

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  bool is_position_anchor(const Measurement& measurement) const;
  bool is_root(const Measurement& measurement) const;
  Node movable_end(const Measurement& measurement) const;
  void add_free_root(Node node);
  void flood(Node start, std::uint32_t label);

  const FrameGraph& frames_;
  const StopToken& stop_;
  PacedStop pace_;
  std::vector<std::uint32_t> label_;  // for each node: an index in free_roots_, kRooted or kNone
  std::vector<Node> free_roots_;
  std::vector<Node> stack_;
};

}  // namespace boxplus::guess
