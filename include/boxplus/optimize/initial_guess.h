// SPDX-License-Identifier: BSD-3-Clause
// Estimates to begin from, made of the relative measurements alone: whatever the estimates were before does
// not matter.
//
// A relative measurement is an edge whose type has a relative_frame() hook (graph/frame.h); vertices are
// poses and points where their type has a FrameTrait. What all guesses have in common:
//
//   - Only active vertices of the plan move, and never a parameter. Those that no relative measurement
//     reaches keep their estimates, as do vertices of other types. Edges that are disabled or weigh nothing
//     are ignored.
//   - Roots are the fixed and inactive vertices, the plan's held ones, and absolute measurements
//     (RelativeFrame::kWorld). Where no root reaches, the pose of lowest id stays where it is; if absolute
//     positions were measured there, or points of known position seen, all is then moved rigidly onto them.
//   - They give the same bits in every run.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"
#include "boxplus/linearize/plan.h"

namespace boxplus {

struct [[nodiscard]] GuessResult {
  bool made = false;      ///< false: all estimates are as they were
  std::string_view note;  ///< why it was not made; static text
};

/// Bounds of what a guess may take, and what helps it.
struct GuessLimits {
  StopToken stop = {};                 ///< once raised, no guess is made
  std::uint64_t max_factor_bytes = 0;  ///< as AutomaticSolverOptions::max_factor_bytes
  int threads = 1;                     ///< the result does not depend on it
  /// An order in which to eliminate the blocks of the plan, or some of them; empty: it looks for one.
  std::span<const std::uint32_t> order = {};
};

/// Chains the measurements between poses that follow each other by id (landmarks in between do not count).
/// Where the chain is broken, as few other measurements as possible bridge the gap. O(n log n).
GuessResult guess_odometry(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

/// Follows the shortest paths from the roots (Dijkstra). An edge costs the variance that it adds: that of its
/// translation, plus that of its rotation times the mean squared length of the measured translations.
/// O(n log n).
GuessResult guess_spanning_tree(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

/// Solves one joint sparse linear least-squares problem for relaxed rotations, positions and landmarks,
/// projects the rotations onto SO(d), and solves again for positions and landmarks with these. What is not
/// measured in all directions keeps its estimate in the others, and the note says so. The cost is about that
/// of one Gauss-Newton iteration. (Martinec & Pajdla, "Robust rotation and translation estimation in
/// multiview reconstruction", CVPR 2007; Carlone, Tron, Daniilidis & Dellaert, "Initialization techniques for
/// 3D SLAM: a survey on rotation estimation and its use in pose graph optimization", ICRA 2015.)
GuessResult guess_chordal(Graph& graph, const Plan& plan, const GuessLimits& limits = {});

}  // namespace boxplus
