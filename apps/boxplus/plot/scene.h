// SPDX-License-Identifier: BSD-3-Clause
// The visible parts of a graph: segments and dots on a plane, each with a depth.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// A point of the picture plane (in meters, y points up) and its depth. A larger depth is nearer to the
/// viewer.
using Spot = std::array<double, 3>;

/// The kinds of segments, in the order in which they are drawn.
enum class SegmentKind : std::uint8_t { kTruth, kObservation, kLoopClosure, kTrajectory };

struct Segment {
  SegmentKind kind;
  Spot from, to;
  double time;          ///< the time along the trajectory, in [0, 1]
  double chi2_per_row;  ///< chi2 per row of the edge, after its kernel
};

struct Dot {
  Spot spot;
  double time;  ///< the time of the pose, in [0, 1]
};

/// The region of the picture plane that contains a pose or a point with 95 % probability.
struct Ellipse {
  Spot center;
  std::array<double, 2> long_axis, short_axis;  ///< the semi-axes, in meters
  bool is_pose;
  double time;  ///< the time of the pose, in [0, 1]
};

/// A point of bundle adjustment.
struct SeenPoint {
  Spot spot;
  double chi2_per_row;  ///< the mean of its observations, after their kernels
};

/// A camera of bundle adjustment, drawn as a pyramid whose first corner is the center.
struct CameraMark {
  std::array<Spot, 5> corners;
  double time;  ///< the time of the camera, in [0, 1]
};

/// A name at a point.
struct Label {
  Spot spot;
  std::string text;
};

struct Scene {
  std::vector<Segment> segments;  ///< all segments, in the order of time
  std::vector<Spot> landmarks;
  std::vector<Dot> dots;  ///< the poses that are not on the trajectory; if there are few poses, all of them
  std::vector<SeenPoint> points;    ///< only in bundle adjustment, instead of landmarks and observations
  std::vector<CameraMark> cameras;  ///< only in bundle adjustment, instead of a trajectory
  std::vector<Ellipse> ellipses;
  std::vector<Spot> scan_points;  ///< that lasers have hit
  std::vector<Label> labels;
  std::vector<std::array<Spot, 2>> matches;  ///< from a vertex to a point that may be the same place
  bool has_ellipses =
      false;           ///< true if the user asked for ellipses, even if all of them are too small to see
  Spot low{}, high{};  ///< two corners of the box around everything
  std::size_t poses = 0, landmark_count = 0, edges = 0, scans = 0;
  /// The number of vertices that are not drawn, because they are too far away or not finite.
  std::size_t hidden = 0;
  /// The number of points of bundle adjustment that are not drawn, because they are far away from most
  /// others.
  std::size_t outside = 0;
  bool is_bundle = false;   ///< true if the graph is one of bundle adjustment
  bool is_spatial = false;  ///< true if the graph is in space, and drawn in parallel projection
  double chi2 = 0;          ///< chi2 of the graph, after its kernels
  std::string kernel;       ///< the name of the first kernel of an edge; empty if no edge has a kernel
  std::string title;

  bool has(SegmentKind kind) const;
};

/// The direction from which graphs in space are seen. The projection is parallel, so that lengths can be
/// compared. At azimuth 0 and elevation 0, x points to the right and z points up. At azimuth 0 and elevation
/// 90, x points to the right and y points up.
struct View {
  double azimuth_deg = -31.5, elevation_deg = 24;
  /// Rotates the world before it is seen; row-major.
  std::array<double, 9> leveling{1, 0, 0, 0, 1, 0, 0, 0, 1};
  bool operator==(const View&) const = default;
};
/// Projects the point (x, y, z) onto the picture plane. Points of a graph in the plane are seen from above
/// for any view.
Spot project(const std::array<double, 3>& point, int dimension, const View& view);

/// The true positions of vertices by id, in the frame of the graph.
using TruePlaces = std::unordered_map<Id, std::array<double, 3>>;

/// Makes the scene of a graph. Edges between poses with consecutive ids form the trajectory. All other edges
/// between poses are loop closures; edges between a pose and a point are observations. The truth is drawn
/// along the trajectory.
Scene make_scene(const Graph& graph, std::string title, const View& view = {}, const TruePlaces& truth = {});

}  // namespace boxplus::app
