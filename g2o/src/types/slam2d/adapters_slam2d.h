// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/types/slam2d.h"
#include "g2o/core/factory.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "types/adapters.h"

// Every source that includes this header refers to the source that registers the tags of all types. Without
// this, a linker would leave that source out of a program that links the static library.
G2O_USE_TYPE_GROUP(slam2d)

namespace g2o {
namespace adapters {

inline boxplus::SE2 pose(const SE2& x) {
  return {x.translation().x(), x.translation().y(), x.rotation().angle()};
}
inline boxplus::SE2 pose(const VertexSE2& v) {
  return pose(v.estimate());
}
inline SE2 to_g2o(const boxplus::SE2& x) {
  return {x.x(), x.y(), x.theta()};
}
inline boxplus::Vector2 point(const Vector2& p) {
  return p;
}
inline boxplus::Vector2 point(const VertexPointXY& v) {
  return v.estimate();
}

}  // namespace adapters

inline boxplus::SE2 native_value(const VertexSE2& v) {
  return adapters::pose(v);
}
inline boxplus::Vector2 native_value(const VertexPointXY& v) {
  return v.estimate();
}

namespace internal {

template <>
struct MeasurementAdapter<SE2> {
  static constexpr int kSize = 3;
  using Native = boxplus::SE2;
  static Native native(const SE2& z, const KeptMeasurement<SE2>&) { return adapters::pose(z); }
  static SE2 to_g2o(const Native& z) { return adapters::to_g2o(z); }
  static SE2 from_data(const double* d) { return {d[0], d[1], d[2]}; }
  static Vector3 to_data(const SE2& z, const KeptMeasurement<SE2>&) { return z.toVector(); }
};

}  // namespace internal
}  // namespace g2o
