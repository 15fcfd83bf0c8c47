// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <typeinfo>
#include <utility>

#include "boxplus/types/inertial.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "edge_kind.h"
#include "edge_kinds.h"
#include "landmark_values.h"

namespace boxplus::python {
std::span<const EdgeFamily> edge_families() {
  static constexpr EdgeFamily kFamilies[] = {
      {"Between",
       "Measures a pose, a rotation or a point relative to another one of the same type. Vertices: a, b."},
      {"Prior", "Measures a pose, a rotation, a direction, a point, a plane or a line in the world."},
      {"PositionPrior", "Measures the position of a pose in the world, for example by GPS."},
      {"OffsetPositionPrior",
       "Measures the position of a sensor on a pose in the world, such as an antenna. Vertices: pose, "
       "position "
       "of the sensor in the frame of the pose (lever arm)."},
      {"PointObservation2", "Measures a point in the frame of a pose in the plane. Vertices: pose, point."},
      {"PointObservation3", "Measures a point in the frame of a pose in space. Vertices: pose, point."},
      {"OffsetPointObservation2",
       "Measures a point in the frame of a sensor. Vertices: pose, point, sensor."},
      {"OffsetPointObservation3",
       "Measures a point in the frame of a sensor. Vertices: pose, point, sensor."},
      {"BearingObservation2", "Measures the angle to a point (radians). Vertices: pose, point."},
      {"BearingObservation3", "Measures the direction of a point. Vertices: pose, point."},
      {"Range",
       "Measures the distance between two positions (meters). Vertices: a pose or a point, a pose or a "
       "point."},
      {"PlaneObservation3",
       "Measures a plane in the frame of a pose or of a sensor. Vertices: pose, plane; or pose, plane, "
       "sensor."},
      {"PlaneDifference3",
       "Measures the difference of the coefficients of two planes, in the scale |n| = 1. Vertices: first, "
       "second."},
      {"LineObservation3",
       "Measures a line in the frame of a pose or of a sensor. Vertices: pose, line; or pose, line, sensor."},
      {"Reprojection",
       "Measures the pixel at which a camera sees a point. Vertices: pose (T_world_camera), point, camera; "
       "or (pose, camera), point."},
      {"CalibratedReprojection",
       "Measures the pixel at which a camera with known parameters sees a point. Vertices: pose "
       "(T_world_camera), point.",
       true},
  };
  return kFamilies;
}

std::span<const EdgeKind> edge_kinds() {
  static const auto kinds = [] {
    std::vector<EdgeKind> all{
        edge_kind<Between<SE2>, SE2, SE2>("Between"),
        edge_kind<Between<SE3>, SE3, SE3>("Between"),
        edge_kind<Between<Vector2>, Vector2, Vector2>("Between"),
        edge_kind<Between<Vector3>, Vector3, Vector3>("Between"),
        edge_kind<Between<SO2>, SO2, SO2>("Between"),
        edge_kind<Between<SO3>, SO3, SO3>("Between"),
        edge_kind<Between<Sim3>, Sim3, Sim3>("Between"),
        edge_kind<Prior<SE2>, SE2>("Prior"),
        edge_kind<Prior<SE3>, SE3>("Prior"),
        edge_kind<Prior<Vector2>, Vector2>("Prior"),
        edge_kind<Prior<Vector3>, Vector3>("Prior"),
        edge_kind<Prior<SO2>, SO2>("Prior"),
        edge_kind<Prior<SO3>, SO3>("Prior"),
        edge_kind<Prior<S2>, S2>("Prior"),
        edge_kind<Prior<Sim3>, Sim3>("Prior"),
        edge_kind<Prior<Plane3>, Plane3>("Prior"),
        edge_kind<Prior<Line3>, Line3>("Prior"),
        edge_kind<PositionPrior<Vector2>, SE2>("PositionPrior"),
        edge_kind<PositionPrior<Vector3>, SE3>("PositionPrior"),
        edge_kind<OffsetPositionPrior<Vector2>, SE2, Vector2>("OffsetPositionPrior"),
        edge_kind<OffsetPositionPrior<Vector3>, SE3, Vector3>("OffsetPositionPrior"),
        edge_kind<PointObservation2, SE2, Vector2>("PointObservation2"),
        edge_kind<PointObservation3, SE3, Vector3>("PointObservation3"),
        edge_kind<OffsetPointObservation2, SE2, Vector2, SE2>("OffsetPointObservation2"),
        edge_kind<OffsetPointObservation3, SE3, Vector3, SE3>("OffsetPointObservation3"),
        edge_kind<BearingObservation2, SE2, Vector2>("BearingObservation2"),
        edge_kind<BearingObservation3, SE3, Vector3>("BearingObservation3"),
        edge_kind<Range, SE2, Vector2>("Range"),
        edge_kind<Range, SE2, SE2>("Range"),
        edge_kind<Range, Vector2, SE2>("Range"),
        edge_kind<Range, Vector2, Vector2>("Range"),
        edge_kind<Range, SE3, Vector3>("Range"),
        edge_kind<Range, SE3, SE3>("Range"),
        edge_kind<Range, Vector3, SE3>("Range"),
        edge_kind<Range, Vector3, Vector3>("Range"),
        edge_kind<PlaneObservation3, SE3, Plane3>("PlaneObservation3"),
        edge_kind<PlaneObservation3, SE3, Plane3, SE3>("PlaneObservation3"),
        edge_kind<PlaneDifference3, Plane3, Plane3>("PlaneDifference3"),
        edge_kind<LineObservation3, SE3, Line3>("LineObservation3"),
        edge_kind<LineObservation3, SE3, Line3, SE3>("LineObservation3"),
    };
    for (EdgeKind& kind : camera_edge_kinds()) all.push_back(std::move(kind));
    for (EdgeKind& kind : known_camera_edge_kinds()) all.push_back(std::move(kind));
    return all;
  }();
  return kinds;
}

std::string family_of(py::handle edge) {
  const bool is_class = py::isinstance<py::type>(edge);
  const py::handle type = is_class ? edge : py::handle(py::type::handle_of(edge));
  const py::module_ package = py::module_::import("boxplus");
  std::string names;
  for (const EdgeFamily& family : edge_families()) {
    if (type.is(package.attr(family.name))) return family.name;
    names += (names.empty() ? "" : ", ") + std::string(family.name);
  }
  throw_type_error("edge", "one of " + names, edge);
}

py::object camera_of(py::handle edge) {
  if (py::isinstance<CameraEdgeValue>(edge)) return edge.cast<const CameraEdgeValue&>().camera;
  return py::none();
}

const EdgeKind& kind_for(const std::string& family, const Graph& graph, std::span<const VertexRef> vertices,
                         py::handle camera) {
  std::string expected, came, cameras;
  std::vector<std::type_index> pools;
  for (const VertexRef& vertex : vertices) {
    if (!graph.contains(vertex)) static_cast<void>(graph.id(vertex));  // throws
    const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    pools.emplace_back(typeid(pool));
    came += (came.empty() ? "" : ", ") + std::string(pool.type_name());
  }
  bool fits = false, has_camera = false;
  for (const EdgeKind& kind : edge_kinds()) {
    if (kind.family != family) continue;
    if (kind.pools == pools) {
      fits = true;
      if (kind.is_camera == nullptr ? camera.is_none() : kind.is_camera(camera)) return kind;
    }
    const std::string text = "(" + kind.vertices + ")";
    if (expected.find(text) == std::string::npos) expected += (expected.empty() ? "" : " or ") + text;
    has_camera = has_camera || kind.is_camera != nullptr;
    cameras += (cameras.empty() ? "" : ", ") + std::string(kind.camera_name);
  }
  if (fits)
    throw_type_error(
        "camera", has_camera ? "one of " + cameras : "None, because " + family + " takes no camera", camera);
  throw py::type_error(family + ": expected vertices of the types " + expected + ", got (" + came + ")");
}

const EdgeKind& kind_of_edge(const Graph& graph, EdgeRef edge) {
  if (!graph.contains(edge)) static_cast<void>(graph.level(edge));  // throws
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  for (const EdgeKind& kind : edge_kinds()) {
    if (kind.pool == typeid(pool)) return kind;
  }
  throw py::type_error("edge: expected a type that Python knows, got a " + std::string(pool.type_name()) +
                       ", which has no Python class");
}

}  // namespace boxplus::python
