// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d_addons/edge_se2_segment2d.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_line.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_pointLine.h"
#include "types/ready_made_edge.h"
#include "types/slam2d_addons/adapters_slam2d_addons.h"

namespace g2o {
namespace internal {
namespace {

/// What z measures is the error of z = 0.
template <class Native, class Edge>
auto seen(const Native& zero, const Edge& e) {
  return zero.error(native_value(*e.template vertexXn<0>()), native_value(*e.template vertexXn<1>()));
}

}  // namespace

template <>
struct EdgeModel<EdgeSE2Segment2D> {
  using Native = boxplus::SegmentObservation2;
  static Vector4 measured(const EdgeSE2Segment2D& e) { return seen(Native(Vector4::Zero()), e); }
  static Vector4 second(const EdgeSE2Segment2D& e) {
    Vector4 ends;
    ends << estimate<0>(e) * e.measurementP1(), estimate<0>(e) * e.measurementP2();
    return ends;
  }
};

template <>
struct EdgeModel<EdgeSE2Segment2DLine> {
  using Native = boxplus::SegmentLineObservation2;
  static Vector2 measured(const EdgeSE2Segment2DLine& e) { return seen(Native(Vector2::Zero()), e); }
};

template <>
struct EdgeModel<EdgeSE2Segment2DPointLine> {
  using Native = boxplus::SegmentEndObservation2;
  static constexpr int kFields = 4;
  static Native native(const EdgeSE2Segment2DPointLine& e) { return {e.measurement(), e.pointNum() != 0}; }
  static void taken(EdgeSE2Segment2DPointLine& e, const Native& read) {
    e.setPointNum(read.is_second ? 1 : 0);
  }
  static Vector3 measured(const EdgeSE2Segment2DPointLine& e) {
    return seen(Native(Vector3::Zero(), e.pointNum() != 0), e);
  }
};

template struct EdgeFunctions<EdgeSE2Segment2D>;
template struct EdgeFunctions<EdgeSE2Segment2DLine>;
template struct EdgeFunctions<EdgeSE2Segment2DPointLine>;

}  // namespace internal

EdgeSE2Segment2D::EdgeSE2Segment2D() = default;
EdgeSE2Segment2DLine::EdgeSE2Segment2DLine() = default;
EdgeSE2Segment2DPointLine::EdgeSE2Segment2DPointLine() = default;

}  // namespace g2o
