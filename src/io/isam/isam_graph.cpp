// SPDX-License-Identifier: BSD-3-Clause
#include "io/isam/isam_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "boxplus/types/between.h"
#include "boxplus/types/slam2d/point_observation.h"
#include "boxplus/types/slam3d/point_observation.h"
#include "io/g2o/notes.h"

namespace boxplus {
namespace {

/// What the ids of landmarks are increased by.
Id landmark_offset(const IsamMeasurements& measurements) {
  Id largest = 0;
  bool overlaps = false;
  for (const auto& [id, type] : measurements.poses) {
    largest = std::max(largest, id);
    overlaps = overlaps || measurements.landmarks.contains(id);
  }
  if (!overlaps) return 0;
  Id power = 10;
  while (power <= largest) power *= 10;
  return power;
}

class IsamGraph {
 public:
  IsamGraph(Id landmark_offset, GraphFile& file) : offset_(landmark_offset), file_(file) {}

  void add(const IsamMeasurements::One& one) {
    std::visit([&](const auto& value) { add(value, one); }, one.value);
  }

  void add_notes() {
    const auto count = static_cast<std::int64_t>(graph().vertex_count());
    if (count == 0) return;
    file_.vertices_created = true;
    if (offset_ > 0) {
      file_.notes.push_back(
          {0,
           fmt::format("poses and landmarks have the same ids: landmark n became vertex {} + n", offset_)});
    }
    file_.notes.push_back(
        {0, fmt::format("the file has edges only: {} an initial guess",
                        counted(count, "vertex was created and needs", "vertices were created and need"))});
  }

 private:
  Graph& graph() { return file_.graph; }

  template <class T>
  VertexHandle<T> vertex(Id id, const T& start) {
    if (graph().find_vertex(id)) return graph().vertex<T>(id);
    return graph().add_vertex(start, id);
  }

  template <class Pose>
  requires std::is_same_v<Pose, SE2> || std::is_same_v<Pose, SE3>
  void add(const Pose& motion, const IsamMeasurements::One& one) {
    const auto from = vertex(one.from, Pose()), to = vertex(one.to, Pose());
    file_.edges.push_back(graph().add_edge(Between(motion), one.information, from, to));
  }
  void add(const Vector2& point, const IsamMeasurements::One& one) {
    const auto pose = vertex(one.from, SE2());
    const auto landmark = vertex(one.to + offset_, Vector2(0, 0));
    file_.edges.push_back(graph().add_edge(PointObservation2(point), one.information, pose, landmark));
  }
  void add(const Vector3& point, const IsamMeasurements::One& one) {
    const auto pose = vertex(one.from, SE3());
    const auto landmark = vertex(one.to + offset_, Vector3(0, 0, 0));
    if (!sensor_) sensor_ = graph().add_parameter(SE3());
    file_.edges.push_back(
        graph().add_edge(OffsetPointObservation3(point), one.information, pose, landmark, *sensor_));
  }

  Id offset_;
  GraphFile& file_;
  std::optional<VertexHandle<SE3>> sensor_;  // the sensor is at the origin of the robot
};

}  // namespace

void add_isam(const IsamMeasurements& measurements, GraphFile& file) {
  IsamGraph graph(landmark_offset(measurements), file);
  for (const IsamMeasurements::One& one : measurements.all) graph.add(one);
  graph.add_notes();
}

}  // namespace boxplus
