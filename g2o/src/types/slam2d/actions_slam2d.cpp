// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"
#include "g2o/types/slam2d/types_slam2d.h"
#include "types/actions.h"
#include "types/slam2d/lift.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam2d_actions)

namespace {

using internal::lift;
using internal::Sketch;

struct Slam2d {
  static constexpr int kDimension = 2;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* pose = dynamic_cast<const VertexSE2*>(v)) return lift(pose->estimate().translation());
    if (const auto* point = dynamic_cast<const VertexPointXY*>(v)) return lift(point->estimate());
    return {};
  }

  static Sketch sketch(const VertexSE2& v) { return Sketch::of_pose(lift(v.estimate())); }
  static Sketch sketch(const VertexPointXY& v) { return Sketch::of_point(lift(v.estimate())); }
  static Sketch sketch(const CacheSE2Offset& cache) { return Sketch::of_sensor(lift(cache.n2w())); }
  static Sketch sketch(const EdgeSE2& e) {
    return internal::sketch_of_motion(e, [](const SE2& x) { return lift(x); });
  }
  static Sketch sketch(const EdgeSE2Offset& e) {
    return internal::sketch_of_edge<Slam2d>(e, internal::kMotionColor);
  }
  static Sketch sketch(const EdgeSE2PointXY& e) {
    return internal::sketch_of_observation<Slam2d>(e,
                                                   [&](const SE2& x) { return lift(x * e.measurement()); });
  }
  static Sketch sketch(const EdgeSE2Prior& e) {
    return internal::sketch_of_prior<Slam2d>(e, lift(e.measurement().translation()));
  }
  static Sketch sketch(const EdgeSE2XYPrior& e) {
    return internal::sketch_of_prior<Slam2d>(e, lift(e.measurement()));
  }
  static Sketch sketch(const EdgeXYPrior& e) {
    return internal::sketch_of_prior<Slam2d>(e, lift(e.measurement()));
  }
  /// The third vertex, the pose of the sensor on the robot, has no position in the world.
  static Sketch sketch(const EdgeSE2PointXYCalib& e) {
    const std::optional<Vector3> from = place(e.vertex(0)), to = place(e.vertex(1));
    return from && to ? Sketch::of_line(*from, *to, internal::kObservationColor) : Sketch();
  }
  template <class Observation>
  static Sketch sketch(const Observation& e) {
    return internal::sketch_of_edge<Slam2d>(e, internal::kObservationColor);
  }

  static bool write(const VertexSE2& v, std::ostream& os) {
    internal::write_line(os, v.estimate().toVector());
    return true;
  }
  static bool write(const VertexPointXY& v, std::ostream& os) {
    internal::write_line(os, v.estimate());
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
};

const internal::RegisterActions<Slam2d, VertexSE2, VertexPointXY, EdgeSE2, EdgeSE2PointXY,
                                EdgeSE2PointXYBearing, EdgeSE2Prior, EdgeSE2XYPrior, EdgeXYPrior, EdgePointXY,
                                EdgeSE2PointXYCalib, EdgeSE2Offset, EdgeSE2PointXYOffset, EdgeSE2TwoPointsXY,
                                EdgeSE2LotsOfXY>
    actions;
const RegisterActionProxy<internal::DrawElementAction<Slam2d, CacheSE2Offset>> draw_cache;

}  // namespace

VertexSE2WriteGnuplotAction::VertexSE2WriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2d, VertexSE2>>()) {}
VertexSE2DrawAction::VertexSE2DrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2d, VertexSE2>>()) {}
VertexPointXYWriteGnuplotAction::VertexPointXYWriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2d, VertexPointXY>>()) {}
VertexPointXYDrawAction::VertexPointXYDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2d, VertexPointXY>>()) {}
EdgeSE2WriteGnuplotAction::EdgeSE2WriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2d, EdgeSE2>>()) {}
EdgeSE2DrawAction::EdgeSE2DrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2d, EdgeSE2>>()) {}
EdgeSE2PointXYWriteGnuplotAction::EdgeSE2PointXYWriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2d, EdgeSE2PointXY>>()) {}
EdgeSE2PointXYDrawAction::EdgeSE2PointXYDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2d, EdgeSE2PointXY>>()) {}
EdgeSE2PointXYBearingWriteGnuplotAction::EdgeSE2PointXYBearingWriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2d, EdgeSE2PointXYBearing>>()) {}
EdgeSE2PointXYBearingDrawAction::EdgeSE2PointXYBearingDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2d, EdgeSE2PointXYBearing>>()) {}

}  // namespace g2o
