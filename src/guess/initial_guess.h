// SPDX-License-Identifier: BSD-3-Clause
// Initial estimates from the relative measurements alone. They do not depend on the current estimates of the
// vertices that they set.
//
// A relative measurement is an edge whose type has a relative_frame() hook (graph/frame.h). A vertex is a
// pose or a point if its type has a FrameTrait. All functions of this header follow the same rules:
//
//   - Only active vertices of the plan move; parameters never move. A vertex keeps its estimate if no
//     relative measurement reaches it, or if it is not a pose or point. Edges that are disabled or have zero
//     weight are ignored.
//   - The roots are the fixed vertices, the inactive vertices, the vertices that the plan holds, and absolute
//     measurements (RelativeFrame::kWorld). In a component without a root, the pose of lowest id keeps its
//     place. If there are measurements of absolute positions, or of points with known positions, the
//     component is then moved rigidly to fit them.
//   - A guess is bitwise reproducible: it has the same bits in every run.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"
#include "plan/plan.h"

namespace boxplus {

struct [[nodiscard]] GuessResult {
  bool made = false;      ///< false: all estimates are as they were
  std::string_view note;  ///< the reason why no guess was made; static text
};

/// The resources that a guess may use.
struct GuessLimits {
  StopToken stop = {};                 ///< if it is raised, the guess ends without a result
  std::uint64_t max_factor_bytes = 0;  ///< see AutomaticSolverOptions::max_factor_bytes
  int threads = 1;                     ///< maximum number; it does not affect the result
  /// An order in which to eliminate all or some of the plan's blocks; empty: the guess computes one.
  std::span<const std::uint32_t> order = {};
};

/// Chains the measurements between poses with consecutive ids (ids of landmarks do not break the sequence).
/// If the chain has a gap, the fewest possible other measurements bridge it. O(n log n).
GuessResult guess_odometry(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

/// Follows the shortest paths from the roots (Dijkstra). The length of an edge is the variance that it adds:
/// the variance of its translation, plus the variance of its rotation times the mean squared length of the
/// measured translations. O(n log n).
GuessResult guess_spanning_tree(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

/// Solves one joint sparse linear least-squares problem for relaxed rotations, positions and landmarks,
/// projects the rotations onto SO(d), and solves again for positions and landmarks with these rotations. If a
/// vertex is not measured in all directions, it keeps its estimate in the directions that are not measured,
/// and the note says so. The cost is about that of one Gauss-Newton iteration. (Martinec & Pajdla, "Robust
/// rotation and translation estimation in multiview reconstruction", CVPR 2007; Carlone, Tron, Daniilidis &
/// Dellaert, "Initialization techniques for 3D SLAM: a survey on rotation estimation and its use in pose
/// graph optimization", ICRA 2015.)
GuessResult guess_chordal(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

}  // namespace boxplus
