// SPDX-License-Identifier: BSD-3-Clause
// Which parts of the graph have a root, and what to do about the others.
#pragma once

#include <cstdint>
#include <vector>

#include "optimize/initial_guess/frame_graph.h"

namespace boxplus::guess {

/// The connected parts of the movable vertices; landmarks connect the poses that see them, constants do not.
///
/// A part has a root where a constant pose or the world is measured together with a pose of it, or a constant
/// pose sees one of its points. Other absolute measurements (a position of a pose, a point of known position)
/// tell too little to start from: a part that has only these is guessed from its pose of lowest id, then
/// moved onto them.
class Components {
 public:
  /// Throws Stopped once the token is raised, which must outlive it; so does align().
  explicit Components(const FrameGraph& frames, const StopToken& stop);

  /// The poses (in parts without poses, the points) that stand in for missing roots.
  const std::vector<Node>& free_roots() const { return free_roots_; }
  /// True for the absolute positions of a part without root.
  bool left_for_alignment(const Measurement& measurement) const;
  /// Moves each part without root rigidly onto the absolute positions measured in it (Umeyama, "Least-squares
  /// estimation of transformation parameters between two point patterns", 1991).
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
  std::vector<std::uint32_t> label_;  // per node: index into free_roots_, kRooted or kNone
  std::vector<Node> free_roots_;
  std::vector<Node> stack_;
};

}  // namespace boxplus::guess
