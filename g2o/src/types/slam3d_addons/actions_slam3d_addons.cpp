// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/slam3d_addons/types_slam3d_addons.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam3d_addons_actions)

namespace {

using internal::Sketch;

/// A frame at the point of a plane that is nearest to `viewer`. The z-axis is the normal of the plane, and
/// the x-axis is horizontal.
Isometry3 piece(const Plane3D& plane, const Vector3& viewer) {
  const Vector3 z = plane.normal();
  const Vector3 level = Vector3::UnitZ().cross(z);
  const Vector3 x = level.norm() > 1e-6 ? Vector3(level.normalized()) : Vector3(Vector3::UnitX());
  Isometry3 result = Isometry3::Identity();
  result.linear() << x, z.cross(x), z;
  result.translation() = viewer - (z.dot(viewer) - plane.distance()) * z;
  return result;
}

/// The point of a line that is nearest to `viewer`, and the direction of the line.
std::array<Vector3, 2> piece(const Line3D& line, const Vector3& viewer) {
  const Vector6 coordinates = line.toCartesian();
  const Vector3 p = coordinates.head<3>(), d = coordinates.tail<3>();
  return {p + d.dot(viewer - p) * d, d};
}

Color color_of(const Vector3& rgb) {
  return {rgb[0], rgb[1], rgb[2], 1};
}

struct Slam3dAddons {
  static constexpr int kDimension = 3;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* pose = dynamic_cast<const VertexSE3*>(v)) return pose->estimate().translation();
    if (const auto* plane = dynamic_cast<const VertexPlane*>(v))
      return piece(plane->estimate(), Vector3::Zero()).translation();
    if (const auto* line = dynamic_cast<const VertexLine3D*>(v))
      return piece(line->estimate(), Vector3::Zero())[0];
    return {};
  }

  static Sketch sketch(const VertexPlane& v) {
    Sketch sketch;
    sketch.planes = {piece(v.estimate(), Vector3::Zero())};
    sketch.color = color_of(v.color);
    return sketch;
  }
  static Sketch sketch(const VertexLine3D& v) {
    Sketch sketch;
    sketch.pieces = {piece(v.estimate(), Vector3::Zero())};
    sketch.color = color_of(v.color);
    return sketch;
  }
  static Sketch sketch(const VertexSE3Euler& v) { return Sketch::of_pose(v.estimate()); }
  static Sketch sketch(const EdgeSE3Euler& e) {
    return internal::sketch_of_motion(e, [](const Isometry3& x) { return x; });
  }
  static Sketch sketch(const EdgePlane& e) {
    return internal::sketch_of_edge<Slam3dAddons>(e, internal::kObservationColor);
  }
  /// The measured plane, drawn at the point of the plane that is nearest to the sensor. The third vertex is
  /// the pose of the sensor on the robot.
  static Sketch sketch(const EdgeSE3PlaneSensorCalib& e) {
    if (e.vertex(0) == nullptr || e.vertex(2) == nullptr) return {};
    const Isometry3 sensor = e.vertexXn<0>()->estimate() * e.vertexXn<2>()->estimate();
    const Isometry3 seen = piece(sensor * e.measurement(), sensor.translation());
    Sketch sketch = Sketch::of_line(sensor.translation(), seen.translation(), color_of(e.color));
    sketch.planes = {seen};
    sketch.plane_side = 0.5F;
    return sketch;
  }
  /// The measured line, drawn at the point of the line that is nearest to the sensor.
  static Sketch sketch(const EdgeSE3Line3D& e) {
    if (e.vertex(0) == nullptr || e.offsetParameter() == nullptr) return {};
    const Isometry3 sensor = e.vertexXn<0>()->estimate() * e.offsetParameter()->offset();
    const std::array<Vector3, 2> seen = piece(sensor * e.measurement(), sensor.translation());
    Sketch sketch = Sketch::of_line(sensor.translation(), seen[0], color_of(e.color));
    sketch.pieces = {seen};
    sketch.piece_length = 4;
    return sketch;
  }
  /// The motion of the robot. The third vertex is the pose of the sensor on the robot.
  static Sketch sketch(const EdgeSE3Calib& e) {
    const std::optional<Vector3> from = place(e.vertex(0)), to = place(e.vertex(1));
    return from && to ? Sketch::of_line(*from, *to, internal::kMotionColor) : Sketch();
  }

  static bool write(const VertexPlane& v, std::ostream& os) {
    internal::write_line(os, v.estimate().coeffs());
    return true;
  }
  static bool write(const VertexLine3D& v, std::ostream& os) {
    internal::write_line(os,
                         Vector6(v.estimate().toCartesian() + Vector6::Zero()));  // without negative zeros
    return true;
  }
  static bool write(const VertexSE3Euler& v, std::ostream& os) {
    internal::write_line(os, internal::toVectorMQT(v.estimate()));
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }
};

const internal::RegisterActions<Slam3dAddons, VertexPlane, VertexLine3D, VertexSE3Euler, EdgePlane,
                                EdgeSE3Euler, EdgeSE3PlaneSensorCalib, EdgeSE3Line3D, EdgeSE3Calib>
    actions;

}  // namespace

VertexPlaneDrawAction::VertexPlaneDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3dAddons, VertexPlane>>()) {}
VertexLine3DDrawAction::VertexLine3DDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3dAddons, VertexLine3D>>()) {}
EdgeSE3Line3DDrawAction::EdgeSE3Line3DDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3dAddons, EdgeSE3Line3D>>()) {}
EdgeSE3PlaneSensorCalibDrawAction::EdgeSE3PlaneSensorCalibDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam3dAddons, EdgeSE3PlaneSensorCalib>>()) {}

}  // namespace g2o
