// SPDX-License-Identifier: BSD-3-Clause
// The visible shapes of an element, independent of the action that shows them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "g2o/core/drawing.h"
#include "g2o/core/hyper_graph.h"

namespace g2o {
namespace internal {

constexpr Color kPoseColor{0.11, 0.30, 0.65, 1}, kPointColor{0.80, 0.22, 0.14, 1};
constexpr Color kMotionColor{0.25, 0.47, 0.80, 0.8}, kObservationColor{0.45, 0.47, 0.52, 0.45};
constexpr Color kPriorColor{0.16, 0.60, 0.30, 0.9}, kSensorColor{0.90, 0.58, 0.10, 1};

/// The shapes of an element in world coordinates. Planar elements have z = 0.
struct Sketch {
  std::vector<Isometry3> poses;
  /// Poses that the measurement of an edge predicts for missing vertices.
  std::vector<Isometry3> ghosts;
  std::vector<Isometry3> sensors;
  /// The poses of cameras. Cameras look along their z-axis.
  std::vector<Isometry3> cameras;
  /// Pieces of planes. The z-axis of each frame is the normal.
  std::vector<Isometry3> planes;
  /// The default side length of the pieces of planes (meters). A property can change it.
  float plane_side = 3;
  std::vector<Vector3> points;
  std::vector<std::array<Vector3, 2>> lines;
  /// Pieces of endless lines: the middle, and a unit direction.
  std::vector<std::array<Vector3, 2>> pieces;
  /// The default length of the pieces of endless lines (meters), and their width. Properties can change them.
  float piece_length = 15, piece_width = 5;
  Color color;

  static Sketch of_pose(const Isometry3& pose) {
    Sketch sketch;
    sketch.poses = {pose};
    sketch.color = kPoseColor;
    return sketch;
  }
  static Sketch of_point(const Vector3& point) {
    Sketch sketch;
    sketch.points = {point};
    sketch.color = kPointColor;
    return sketch;
  }
  static Sketch of_sensor(const Isometry3& pose) {
    Sketch sketch;
    sketch.sensors = {pose};
    sketch.color = kSensorColor;
    return sketch;
  }
  static Sketch of_camera(const Isometry3& pose, const Color& color) {
    Sketch sketch;
    sketch.cameras = {pose};
    sketch.color = color;
    return sketch;
  }
  static Sketch of_line(const Vector3& from, const Vector3& to, const Color& color) {
    Sketch sketch;
    sketch.lines = {{from, to}};
    sketch.color = color;
    return sketch;
  }
};

/// Returns an edge as lines from its first vertex to each other vertex. `Library::place()` returns the
/// position of a vertex. A vertex that is missing or has no position gets no line.
template <class Library>
Sketch sketch_of_edge(const HyperGraph::Edge& e, const Color& color) {
  Sketch sketch;
  sketch.color = color;
  const std::optional<Vector3> from = Library::place(e.vertex(0));
  for (std::size_t i = 1; from && i < e.vertices().size(); ++i) {
    if (const std::optional<Vector3> to = Library::place(e.vertex(i))) sketch.lines.push_back({*from, *to});
  }
  return sketch;
}

/// Returns an edge over one vertex as a line from the vertex to the measured position.
template <class Library>
Sketch sketch_of_prior(const HyperGraph::Edge& e, const Vector3& measured) {
  const std::optional<Vector3> from = Library::place(e.vertex(0));
  return from ? Sketch::of_line(*from, measured, kPriorColor) : Sketch();
}

/// Returns an edge that observes a point from a pose. If the point vertex is missing, `see(pose)` predicts
/// the point.
template <class Library, class Edge, class See>
Sketch sketch_of_observation(const Edge& e, See&& see) {
  const auto* pose = e.template vertexXn<0>();
  if (pose == nullptr || e.vertex(1) != nullptr) return sketch_of_edge<Library>(e, kObservationColor);
  const Vector3 seen = see(pose->estimate());
  Sketch sketch = Sketch::of_line(*Library::place(pose), seen, kObservationColor);
  sketch.points = {seen};
  return sketch;
}

/// Returns an edge that measures the motion between two poses. If one of the poses is missing, the
/// measurement predicts it.
template <class Edge, class Lift>
Sketch sketch_of_motion(const Edge& e, Lift&& lift) {
  const auto *from = e.template vertexXn<0>(), *to = e.template vertexXn<1>();
  if (from == nullptr && to == nullptr) return {};
  const Isometry3 seen_from =
      lift(from != nullptr ? from->estimate() : to->estimate() * e.measurement().inverse());
  const Isometry3 seen_to = lift(to != nullptr ? to->estimate() : from->estimate() * e.measurement());
  Sketch sketch = Sketch::of_line(seen_from.translation(), seen_to.translation(), kMotionColor);
  if (from == nullptr) sketch.ghosts = {seen_from};
  if (to == nullptr) sketch.ghosts = {seen_to};
  return sketch;
}

}  // namespace internal
}  // namespace g2o
