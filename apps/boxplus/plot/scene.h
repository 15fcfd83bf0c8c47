// SPDX-License-Identifier: BSD-3-Clause
// The visible parts of a graph: segments and dots on a plane, with depth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// A point of the picture plane (meters, y upwards) and its depth: larger is nearer.
using Spot = std::array<double, 3>;

/// In drawing order.
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

/// The region of the picture plane that contains a pose or a point with 95 % probability.
struct Ellipse {
  Spot center;
  std::array<double, 2> long_axis, short_axis;  ///< half axes, meters
  bool is_pose;
  double time;  ///< of a pose, as above
};

struct Scene {
  std::vector<Segment> segments;  ///< those of the trajectory in the order of time
  std::vector<Spot> landmarks;
  std::vector<Dot> dots;  ///< poses that are not on the trajectory; all poses if there are few
  std::vector<Ellipse> ellipses;
  bool has_ellipses = false;  ///< the user asked for ellipses; there are none if all are too small to see
  Spot low{}, high{};         ///< the box around everything
  std::size_t poses = 0, landmark_count = 0, edges = 0;
  std::size_t hidden = 0;   ///< vertices that are too far away to draw, or have no position
  bool is_spatial = false;  ///< drawn by a parallel projection
  double chi2 = 0;          ///< after kernels
  std::string kernel;       ///< the name of a kernel of the edges; empty if no edge has one
  std::string title;

  bool has(SegmentKind kind) const;
};

/// The direction from which graphs in space are seen, in a parallel projection, so that lengths stay
/// comparable. At azimuth 0 and elevation 0, x points to the right and z up; at elevation 90, y points up.
struct View {
  double azimuth_deg = -31.5, elevation_deg = 24;
  bool operator==(const View&) const = default;
};
/// The point (x, y, z) as seen. Points in the plane are seen from above, for any view.
Spot project(const std::array<double, 3>& point, int dimension, const View& view);

/// The true positions of vertices by id, in the frame of the graph.
using TruePlaces = std::unordered_map<Id, std::array<double, 3>>;

/// Poses in the order of their ids form the trajectory. Other edges between poses are loop closures; edges
/// between a pose and a point are observations. The truth is drawn along the trajectory.
Scene make_scene(const Graph& graph, std::string title, const View& view = {}, const TruePlaces& truth = {});

}  // namespace boxplus::app
