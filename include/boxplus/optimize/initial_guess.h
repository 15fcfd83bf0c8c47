// SPDX-License-Identifier: BSD-3-Clause
// Estimates to begin from, made of the relative measurements alone: whatever the estimates were, they do not
// matter.
//
// A relative measurement is an edge whose type has a relative_frame() hook (graph/frame.h); vertices are
// poses and points where their type has a FrameTrait. All guesses
//   - move the active vertices of the plan only, never a parameter; those that no relative measurement
//   reaches keep
//     their estimates, as do vertices of other types; disabled edges and edges without information are
//     ignored;
//   - start from the roots: fixed and inactive vertices, the plan's held ones, and absolute measurements
//     (RelativeFrame::kWorld). In a part of the graph that no root reaches, the pose of lowest id stays where
//     it is; if absolute positions were measured there, or points of known position seen, the part is then
//     moved rigidly onto them;
//   - give the same bits in every run.
#pragma once

#include <string_view>

#include "boxplus/graph/graph.h"
#include "boxplus/linearize/plan.h"

namespace boxplus {

struct GuessResult {
  bool made = false;      ///< false: all estimates are as they were
  std::string_view note;  ///< why it was not made, or what was left out; static text, often empty
};

/// Chains the measurements between poses that follow each other by id (landmarks in between do not count).
/// Where the chain is broken, as few other measurements as possible bridge the gap. O(n log n).
GuessResult guess_odometry(Graph& graph, const Plan& plan);

/// Follows the shortest paths from the roots (Dijkstra). An edge costs the variance it adds far away: that of
/// its translation plus that of its rotation times the mean squared length of the measured translations. O(n
/// log n).
GuessResult guess_spanning_tree(Graph& graph, const Plan& plan);

/// Solves one joint sparse linear least-squares problem for relaxed rotations, positions and landmarks,
/// projects the rotations onto SO(d), and solves for positions and landmarks again with these. It needs no
/// loop to be closed in order, and is close to the optimum unless rotations are very noisy. Not made where
/// the problem is singular. (Martinec & Pajdla, "Robust rotation and translation estimation in multiview
/// reconstruction", CVPR 2007; Carlone, Tron, Daniilidis & Dellaert, "Initialization techniques for 3D SLAM:
/// a survey on rotation estimation and its use in pose graph optimization", ICRA 2015.)
GuessResult guess_chordal(Graph& graph, const Plan& plan);

}  // namespace boxplus
