// SPDX-License-Identifier: BSD-3-Clause
// What a picture of a graph shows: segments and dots on a plane, with depth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// A point of the picture plane (metres, y upwards) and its depth: larger is nearer.
using Spot = std::array<double, 3>;

/// In the order in which they are drawn.
enum class SegmentKind : std::uint8_t { kTruth, kObservation, kLoopClosure, kTrajectory };

struct Segment {
  SegmentKind kind;
  Spot from, to;
  double time;          ///< of the trajectory, in [0, 1]
  double chi2_per_row;  ///< of the edge, after its kernel
};

struct Dot {
  Spot spot;
  double time;  ///< of a pose, as above
};

/// Where a pose or a point lies with 95 %, in the picture plane.
struct Ellipse {
  Spot center;
  std::array<double, 2> long_axis, short_axis;  ///< half axes, metres
  bool is_pose;
  double time;  ///< of a pose, as above
};

struct Scene {
  std::vector<Segment> segments;  ///< those of the trajectory by time
  std::vector<Spot> landmarks;
  std::vector<Dot> dots;  ///< poses that no trajectory passes; all, where they are few
  std::vector<Ellipse> ellipses;
  bool has_ellipses = false;  ///< they were asked for; there are none if all are too small to see
  Spot low{}, high{};         ///< what encloses everything
  std::size_t poses = 0, landmark_count = 0, edges = 0;
  std::size_t hidden = 0;   ///< vertices that are too far away to draw, or nowhere
  bool is_spatial = false;  ///< drawn by a parallel projection
  double chi2 = 0;          ///< after kernels
  std::string kernel;       ///< the name of one that edges have; empty if none has
  std::string title;

  bool has(SegmentKind kind) const;
};

/// The direction from which graphs in space are seen, in a parallel projection, so that lengths stay
/// comparable. At azimuth 0 and elevation 0, x points to the right and z up; at elevation 90, y points up.
struct View {
  double azimuth_deg = -31.5, elevation_deg = 24;
  bool operator==(const View&) const = default;
};
/// The point (x, y, z) as seen. Points in the plane are seen from above, whatever the view.
Spot project(const std::array<double, 3>& point, int dimension, const View& view);

/// True places of vertices by id, in the frame of the graph.
using TruePlaces = std::unordered_map<Id, std::array<double, 3>>;

/// Poses in the order of their ids make the trajectory; other edges between poses are loop closures, those
/// between a pose and a point observations. The truth is drawn along the trajectory.
Scene make_scene(const Graph& graph, std::string title, const View& view = {}, const TruePlaces& truth = {});

}  // namespace boxplus::app
