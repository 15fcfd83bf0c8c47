// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/slam2d/types_slam2d.h"
#include "types/actions.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam2d_actions)

namespace {

using internal::Sketch;

Vector3 lift(const Vector2& p) {
  return {p.x(), p.y(), 0};
}

Isometry3 lift(const SE2& x) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = AngleAxis(x.rotation().angle(), Vector3::UnitZ()).toRotationMatrix();
  pose.translation() = lift(x.translation());
  return pose;
}

struct Slam2d {
  static constexpr int kDimension = 2;

  static Vector3 place(const VertexSE2& v) { return lift(v.estimate().translation()); }
  static Vector3 place(const VertexPointXY& v) { return lift(v.estimate()); }

  static Sketch sketch(const VertexSE2& v) { return Sketch::of_pose(lift(v.estimate())); }
  static Sketch sketch(const VertexPointXY& v) { return Sketch::of_point(lift(v.estimate())); }
  static Sketch sketch(const CacheSE2Offset& cache) { return Sketch::of_sensor(lift(cache.n2w())); }
  static Sketch sketch(const EdgeSE2& e) {
    return internal::sketch_of_motion(e, [](const SE2& x) { return lift(x); });
  }
  static Sketch sketch(const EdgeSE2Offset& e) {
    if (!internal::is_complete(e)) return {};
    return internal::sketch_of_edge<Slam2d>(e, internal::kMotionColor);
  }
  /// A prior: from the estimate to where it should be.
  static Sketch sketch(const EdgeSE2Prior& e) { return sketch_of_prior(e, e.measurement().translation()); }
  static Sketch sketch(const EdgeSE2XYPrior& e) { return sketch_of_prior(e, e.measurement()); }
  static Sketch sketch(const EdgeXYPrior& e) { return sketch_of_prior(e, e.measurement()); }
  /// The third vertex, the pose of the sensor on the robot, is not a place in the world.
  static Sketch sketch(const EdgeSE2PointXYCalib& e) {
    if (!internal::is_complete(e)) return {};
    return Sketch::of_line(place(*e.vertexXn<0>()), place(*e.vertexXn<1>()), internal::kObservationColor);
  }
  template <class Observation>
  static Sketch sketch(const Observation& e) {
    if (!internal::is_complete(e)) return {};
    return internal::sketch_of_edge<Slam2d>(e, internal::kObservationColor);
  }

  static bool write(const VertexSE2& v, std::ostream& os) {
    os << v.estimate().translation().transpose() << " " << v.estimate().rotation().angle() << '\n';
    return true;
  }
  static bool write(const VertexPointXY& v, std::ostream& os) {
    os << v.estimate().transpose() << '\n';
    return true;
  }
  static bool write(const EdgeSE2& e, std::ostream& os) {
    write(*e.vertexXn<0>(), os);
    write(*e.vertexXn<1>(), os);
    os << '\n';
    return true;
  }
  template <class Edge>
  static bool write(const Edge&, std::ostream&) {
    return false;
  }

 private:
  template <class Prior>
  static Sketch sketch_of_prior(const Prior& e, const Vector2& measured) {
    if (!internal::is_complete(e)) return {};
    return Sketch::of_line(place(*e.template vertexXn<0>()), lift(measured), internal::kPriorColor);
  }
};

const internal::RegisterActions<Slam2d, VertexSE2, VertexPointXY, EdgeSE2, EdgeSE2PointXY,
                                EdgeSE2PointXYBearing, EdgeSE2Prior, EdgeSE2XYPrior, EdgeXYPrior, EdgePointXY,
                                EdgeSE2PointXYCalib, EdgeSE2Offset, EdgeSE2PointXYOffset, EdgeSE2TwoPointsXY>
    actions;
const RegisterActionProxy<internal::DrawElementAction<Slam2d, CacheSE2Offset>> draw_cache;

}  // namespace
}  // namespace g2o
