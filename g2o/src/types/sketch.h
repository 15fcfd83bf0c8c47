// SPDX-License-Identifier: BSD-3-Clause
// What there is to see of an element, whoever shows it.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "g2o/core/drawing.h"

namespace g2o {
namespace internal {

constexpr Color kPoseColor{0.11, 0.30, 0.65, 1}, kPointColor{0.80, 0.22, 0.14, 1};
constexpr Color kMotionColor{0.25, 0.47, 0.80, 0.8}, kObservationColor{0.45, 0.47, 0.52, 0.45};
constexpr Color kPriorColor{0.16, 0.60, 0.30, 0.9}, kSensorColor{0.90, 0.58, 0.10, 1};

/// In world coordinates; what lies in a plane has z = 0.
struct Sketch {
  std::vector<Isometry3> poses;
  /// Where a measurement sees a pose that the edge does not have.
  std::vector<Isometry3> ghosts;
  std::vector<Isometry3> sensors;
  std::vector<Vector3> points;
  std::vector<std::array<Vector3, 2>> lines;
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
  static Sketch of_line(const Vector3& from, const Vector3& to, const Color& color) {
    Sketch sketch;
    sketch.lines = {{from, to}};
    sketch.color = color;
    return sketch;
  }
};

/// The position of a vertex, as `Library::place()` tells it.
template <class Library, int N, class Edge>
Vector3 place_of(const Edge& e) {
  return Library::place(*e.template vertexXn<N>());
}

template <class Library, class Edge, std::size_t... N>
Sketch sketch_of_edge(const Edge& e, const Color& color, std::index_sequence<N...>) {
  Sketch sketch;
  sketch.color = color;
  (sketch.lines.push_back({place_of<Library, 0>(e), place_of<Library, static_cast<int>(N) + 1>(e)}), ...);
  return sketch;
}

/// An edge as lines from its first vertex to each of the others. All must be there.
template <class Library, class Edge>
Sketch sketch_of_edge(const Edge& e, const Color& color) {
  return sketch_of_edge<Library>(e, color, std::make_index_sequence<Edge::_nr_of_vertices - 1>());
}

/// A motion from pose to pose; where one of them is missing, the other is where the measurement sees it.
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
