// SPDX-License-Identifier: BSD-3-Clause
// Edges of points in the plane.
#include <cmath>

#include "g2o/core/thread_safe.h"
#include "g2o/types/slam2d/edge_pointxy.h"
#include "g2o/types/slam2d/edge_se2_pointxy.h"
#include "g2o/types/slam2d/edge_se2_pointxy_bearing.h"
#include "g2o/types/slam2d/edge_se2_pointxy_calib.h"
#include "g2o/types/slam2d/edge_se2_pointxy_offset.h"
#include "g2o/types/slam2d/edge_se2_twopointsxy.h"
#include "g2o/types/slam2d/edge_xy_prior.h"
#include "types/ready_made_edge.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgePointXY> {
  using Native = boxplus::Between<boxplus::Vector2>;
  static Vector2 measured(const EdgePointXY& e) { return estimate<1>(e) - estimate<0>(e); }
  static Vector2 first(const EdgePointXY& e) { return estimate<1>(e) - e.measurement(); }
  static Vector2 second(const EdgePointXY& e) { return estimate<0>(e) + e.measurement(); }
};

template <>
struct EdgeModel<EdgeXYPrior> {
  using Native = boxplus::Prior<boxplus::Vector2>;
  static Vector2 measured(const EdgeXYPrior& e) { return estimate<0>(e); }
  static Vector2 first(const EdgeXYPrior& e) { return e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE2PointXY> {
  using Native = boxplus::PointObservation2;
  static Vector2 measured(const EdgeSE2PointXY& e) { return estimate<0>(e).inverse() * estimate<1>(e); }
  static Vector2 second(const EdgeSE2PointXY& e) { return estimate<0>(e) * e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE2PointXYBearing> {
  using Native = boxplus::BearingObservation2;
  static double measured(const EdgeSE2PointXYBearing& e) {
    const Vector2 seen = estimate<0>(e).inverse() * estimate<1>(e);
    return std::atan2(seen[1], seen[0]);
  }
  static Vector2 second(const EdgeSE2PointXYBearing& e) {
    constexpr double kDistance = 2;  // arbitrary, because a bearing does not measure the distance
    const double z = e.measurement();
    return estimate<0>(e) * Vector2(kDistance * std::cos(z), kDistance * std::sin(z));
  }
};

template <>
struct EdgeModel<EdgeSE2PointXYCalib> {
  using Native = boxplus::OffsetPointObservation2;
  static Vector2 measured(const EdgeSE2PointXYCalib& e) {
    return (estimate<0>(e) * estimate<2>(e)).inverse() * estimate<1>(e);
  }
  static Vector2 second(const EdgeSE2PointXYCalib& e) {
    return estimate<0>(e) * (estimate<2>(e) * e.measurement());
  }
};

template <>
struct EdgeModel<EdgeSE2PointXYOffset> {
  using Native = boxplus::OffsetPointObservation2;
  static auto parameters(const EdgeSE2PointXYOffset& e) {
    return std::tuple(adapters::pose(e._offsets[0]->offset()));
  }
  static Vector2 measured(const EdgeSE2PointXYOffset& e) {
    return (estimate<0>(e) * e._offsets[0]->offset()).inverse() * estimate<1>(e);
  }
  static Vector2 second(const EdgeSE2PointXYOffset& e) {
    return estimate<0>(e) * (e._offsets[0]->offset() * e.measurement());
  }
};

template <>
struct EdgeModel<EdgeSE2TwoPointsXY> {
  using Native = boxplus::TwoPointsObservation2;
  static Vector4 measured(const EdgeSE2TwoPointsXY& e) {
    const SE2 inverse = estimate<0>(e).inverse();
    Vector4 z;
    z << inverse * estimate<1>(e), inverse * estimate<2>(e);
    return z;
  }
  static bool possible(const EdgeSE2TwoPointsXY& e, const OptimizableGraph::VertexSet& from,
                       const OptimizableGraph::Vertex* to) {
    return from.count(e.vertices()[0]) > 0 && to != e.vertices()[0];
  }
  static void guess(EdgeSE2TwoPointsXY& e, const OptimizableGraph::Vertex* to) {
    const SE2& x = estimate<0>(e);
    if (to == e.vertices()[1]) e.vertexXn<1>()->setEstimate(x * Vector2(e.measurement().head<2>()));
    if (to == e.vertices()[2]) e.vertexXn<2>()->setEstimate(x * Vector2(e.measurement().tail<2>()));
  }
};

template struct EdgeFunctions<EdgePointXY>;
template struct EdgeFunctions<EdgeXYPrior>;
template struct EdgeFunctions<EdgeSE2PointXY>;
template struct EdgeFunctions<EdgeSE2PointXYBearing>;
template struct EdgeFunctions<EdgeSE2PointXYCalib>;
template struct EdgeFunctions<EdgeSE2PointXYOffset>;
template struct EdgeFunctions<EdgeSE2TwoPointsXY>;

}  // namespace internal

EdgePointXY::EdgePointXY() = default;
EdgeXYPrior::EdgeXYPrior() = default;
EdgeSE2PointXY::EdgeSE2PointXY() = default;
EdgeSE2PointXYBearing::EdgeSE2PointXYBearing() = default;
EdgeSE2PointXYCalib::EdgeSE2PointXYCalib() = default;
EdgeSE2TwoPointsXY::EdgeSE2TwoPointsXY() = default;

EdgeSE2PointXYOffset::EdgeSE2PointXYOffset() {
  resizeParameters(1);
  installParameter(_offsets[0], 0);
}

namespace {

const ThreadSafe<EdgePointXY> kThreadSafePointXY;
const ThreadSafe<EdgeXYPrior> kThreadSafeXYPrior;
const ThreadSafe<EdgeSE2PointXY> kThreadSafeSE2PointXY;

}  // namespace
}  // namespace g2o
