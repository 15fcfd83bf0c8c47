// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "g2o/core/factory.h"
#include "g2o/types/slam2d_addons/types_slam2d_addons.h"
#include "types/actions.h"
#include "types/slam2d/lift.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam2d_addons_actions)

namespace {

using internal::lift;
using internal::Sketch;

constexpr Color kLandmarkColor = internal::kPointColor;
/// How much of a line is drawn if its end points are unknown (meters).
constexpr double kLineLength = 15;

/// The point of a line that is nearest to p.
Vector2 nearest(const Line2D& line, const Vector2& p) {
  const Vector2 n(std::cos(line[0]), std::sin(line[0]));
  return p + (line[1] - n.dot(p)) * n;
}

const VertexPointXY* end_point(const VertexLine2D& v, int id) {
  const OptimizableGraph* graph = v.graph();
  return graph == nullptr || id < 0 ? nullptr : dynamic_cast<const VertexPointXY*>(graph->vertex(id));
}

struct Slam2dAddons {
  static constexpr int kDimension = 2;

  static std::optional<Vector3> place(const HyperGraph::Vertex* v) {
    if (const auto* pose = dynamic_cast<const VertexSE2*>(v)) return lift(pose->estimate().translation());
    if (const auto* segment = dynamic_cast<const VertexSegment2D*>(v))
      return lift(Vector2((segment->estimateP1() + segment->estimateP2()) / 2));
    if (const auto* line = dynamic_cast<const VertexLine2D*>(v))
      return lift(nearest(line->estimate(), Vector2::Zero()));
    return {};
  }

  static Sketch sketch(const VertexSegment2D& v) {
    return Sketch::of_line(lift(v.estimateP1()), lift(v.estimateP2()), kLandmarkColor);
  }
  /// The part between the end points, or the part around the point that is nearest to the origin.
  static Sketch sketch(const VertexLine2D& v) {
    const auto *from = end_point(v, v.p1Id), *to = end_point(v, v.p2Id);
    const Vector2 middle = nearest(v.estimate(), Vector2::Zero());
    const Vector2 half = kLineLength / 2 * Vector2(-std::sin(v.theta()), std::cos(v.theta()));
    const Vector2 first = from != nullptr ? nearest(v.estimate(), from->estimate()) : middle - half;
    const Vector2 second = to != nullptr ? nearest(v.estimate(), to->estimate()) : middle + half;
    return Sketch::of_line(lift(first), lift(second), kLandmarkColor);
  }
  static Sketch sketch(const EdgeLine2D& e) {
    return internal::sketch_of_edge<Slam2dAddons>(e, internal::kMotionColor);
  }
  static Sketch sketch(const EdgeLine2DPointXY& e) {
    const auto* line = e.vertexXn<0>();
    const auto* point = e.vertexXn<1>();
    if (line == nullptr || point == nullptr) return {};
    return observation(point->estimate(), nearest(line->estimate(), point->estimate()));
  }
  static Sketch sketch(const EdgeSE2Line2D& e) {
    const auto* pose = e.vertexXn<0>();
    if (pose == nullptr) return {};
    const auto* line = e.vertexXn<1>();
    const Vector2 eye = pose->estimate().translation();
    return observation(eye,
                       nearest(line != nullptr ? line->estimate() : pose->estimate() * e.measurement(), eye));
  }
  static Sketch sketch(const EdgeSE2Segment2D& e) {
    const auto* pose = e.vertexXn<0>();
    if (pose == nullptr) return {};
    const auto* segment = e.vertexXn<1>();
    const Vector2 eye = pose->estimate().translation();
    Sketch sketch =
        observation(eye, segment != nullptr ? segment->estimateP1() : pose->estimate() * e.measurementP1());
    sketch.lines.push_back(
        {lift(eye), lift(segment != nullptr ? segment->estimateP2() : pose->estimate() * e.measurementP2())});
    return sketch;
  }
  static Sketch sketch(const EdgeSE2Segment2DPointLine& e) {
    const auto* pose = e.vertexXn<0>();
    const auto* segment = e.vertexXn<1>();
    if (pose == nullptr || segment == nullptr) return {};
    return observation(pose->estimate().translation(),
                       e.pointNum() == 0 ? segment->estimateP1() : segment->estimateP2());
  }
  static Sketch sketch(const EdgeSE2Segment2DLine& e) {
    return internal::sketch_of_edge<Slam2dAddons>(e, internal::kObservationColor);
  }

  template <class Element>
  static bool write(const Element&, std::ostream&) {
    return false;
  }

 private:
  static Sketch observation(const Vector2& from, const Vector2& to) {
    return Sketch::of_line(lift(from), lift(to), internal::kObservationColor);
  }
};

const internal::RegisterActions<Slam2dAddons, VertexSegment2D, VertexLine2D, EdgeLine2D, EdgeLine2DPointXY,
                                EdgeSE2Line2D, EdgeSE2Segment2D, EdgeSE2Segment2DLine,
                                EdgeSE2Segment2DPointLine>
    actions;

}  // namespace

VertexSegment2DWriteGnuplotAction::VertexSegment2DWriteGnuplotAction()
    : NamedAction(std::make_unique<internal::GnuplotAction<Slam2dAddons, VertexSegment2D>>()) {}
VertexSegment2DDrawAction::VertexSegment2DDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2dAddons, VertexSegment2D>>()) {}
VertexLine2DDrawAction::VertexLine2DDrawAction()
    : NamedAction(std::make_unique<internal::DrawElementAction<Slam2dAddons, VertexLine2D>>()) {}

}  // namespace g2o
