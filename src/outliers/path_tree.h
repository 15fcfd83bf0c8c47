// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths over accepted edges, and the uncertainty of the motion between any two poses.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "outliers/path_sums.h"

namespace boxplus::outliers {

/// The accepted edges of each pose.
class Neighbors {
 public:
  Neighbors(std::size_t poses, std::span<const PoseEdge* const> edges);
  std::span<const PoseEdge* const> of(std::uint32_t pose) const {
    return std::span(edges_).subspan(start_[pose], start_[pose + 1] - start_[pose]);
  }

 private:
  std::vector<std::uint32_t> start_;
  std::vector<const PoseEdge*> edges_;
};

/// The paths from one pose to all others that it reaches. The length of an edge is its variance of
/// translation plus its variance of rotation times `lever`². O(n log n).
class PathTree {
 public:
  PathTree(const Neighbors& neighbors, std::span<const Motion> estimates, std::uint32_t root, double lever);

  bool reaches(std::uint32_t pose) const { return pose == root_ || parent_[pose] != kNone; }
  /// The spread of T_a⁻¹ T_b along the path of the tree from a to b, or nothing if the tree does not reach
  /// both. It is an upper bound of the uncertainty, because other paths are ignored. O(log n).
  std::optional<Spread> between(std::uint32_t a, std::uint32_t b) const;

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  void set_parent(std::uint32_t pose, std::uint32_t parent);
  std::uint32_t common_ancestor(std::uint32_t a, std::uint32_t b) const;

  std::span<const Motion> estimates_;
  std::uint32_t root_;
  std::vector<std::uint32_t> parent_, depth_;
  std::vector<std::uint32_t>
      jump_;  // an ancestor far above (Myers, "An applicative random-access stack", 1983)
  std::vector<PathSums> sums_;
};

}  // namespace boxplus::outliers
