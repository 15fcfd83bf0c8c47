// SPDX-License-Identifier: BSD-3-Clause
// What a picture of a graph shows: segments and dots on a plane, with depth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// A point of the picture plane (metres, y upwards) and its depth: larger is nearer.
using Spot = std::array<double, 3>;

enum class SegmentKind : std::uint8_t { kObservation, kLoopClosure, kTrajectory };

struct Segment {
  SegmentKind kind;
  Spot from, to;
  double time;          ///< of the trajectory, in [0, 1]
  double chi2_per_row;  ///< of the edge, before its kernel
};

struct Dot {
  Spot spot;
  double time;  ///< of a pose, as above
};

struct Scene {
  std::vector<Segment> segments;  ///< those of the trajectory by time
  std::vector<Spot> landmarks;
  std::vector<Dot> dots;  ///< poses that no trajectory passes; all, where they are few
  Spot low{}, high{};     ///< what encloses everything
  std::size_t poses = 0, landmark_count = 0, edges = 0;
  bool is_spatial = false;  ///< drawn by an oblique parallel projection
  double chi2 = 0;
  std::string title;

  bool has(SegmentKind kind) const;
};

/// Poses in the order of their ids make the trajectory; other edges between poses are loop closures, those
/// between a pose and a point observations.
Scene make_scene(const Graph& graph, std::string title);

}  // namespace boxplus::app
