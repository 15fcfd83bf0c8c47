// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d_addons/edge_line2d.h"
#include "g2o/types/slam2d_addons/edge_line2d_pointxy.h"
#include "g2o/types/slam2d_addons/edge_se2_line2d.h"
#include "types/ready_made_edge.h"
#include "types/slam2d_addons/adapters_slam2d_addons.h"

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgeSE2Line2D> {
  using Native = boxplus::LineObservation2;
  static Line2D measured(const EdgeSE2Line2D& e) { return estimate<0>(e).inverse() * estimate<1>(e); }
  static Line2D second(const EdgeSE2Line2D& e) { return estimate<0>(e) * e.measurement(); }
};

template <>
struct EdgeModel<EdgeLine2D> {
  using Native = boxplus::LineDifference2;
  static Line2D measured(const EdgeLine2D& e) {
    const VertexLine2D &from = *e.vertexXn<0>(), &to = *e.vertexXn<1>();
    return Vector2(normalize_theta(to.theta() - from.theta()), to.rho() - from.rho());
  }
  static Line2D first(const EdgeLine2D& e) { return moved(estimate<1>(e), -e.measurement()); }
  static Line2D second(const EdgeLine2D& e) { return moved(estimate<0>(e), e.measurement()); }

 private:
  static Line2D moved(const Line2D& line, const Vector2& by) {
    return Vector2(normalize_theta(line[0] + by[0]), line[1] + by[1]);
  }
};

template <>
struct EdgeModel<EdgeLine2DPointXY> {
  using Native = boxplus::PointToLine2;
  static double measured(const EdgeLine2DPointXY& e) {
    return Native(0).error(native_value(*e.vertexXn<0>()), native_value(*e.vertexXn<1>()));
  }
};

template struct EdgeFunctions<EdgeSE2Line2D>;
template struct EdgeFunctions<EdgeLine2D>;
template struct EdgeFunctions<EdgeLine2DPointXY>;

}  // namespace internal

EdgeSE2Line2D::EdgeSE2Line2D() = default;
EdgeLine2D::EdgeLine2D() = default;
EdgeLine2DPointXY::EdgeLine2DPointXY() = default;

}  // namespace g2o
