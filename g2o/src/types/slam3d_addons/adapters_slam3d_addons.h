// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/factory.h"
#include "g2o/types/slam3d_addons/vertex_line3d.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"
#include "types/slam3d/adapters_slam3d.h"

G2O_USE_TYPE_GROUP(slam3d_addons)  // registers the tags for clients that use only these types

namespace g2o {
namespace adapters {

inline boxplus::Plane3 plane(const Plane3D& p, const Vector3& color = Vector3::Zero()) {
  return {p.coeffs(), {color[0], color[1], color[2]}};
}
inline boxplus::Plane3 plane(const VertexPlane& v) {
  return plane(v.estimate(), v.color);
}
inline Vector3 color(const boxplus::Plane3& p) {
  return Vector3(p.color[0], p.color[1], p.color[2]);
}
inline boxplus::Line3 line(const Line3D& l) {
  return {l.w(), l.d()};
}
inline boxplus::Line3 line(const VertexLine3D& v) {
  return line(v.estimate());
}
inline Line3D to_g2o(const boxplus::Line3& l) {
  Vector6 v;
  v << l.moment, l.direction;
  return Line3D(v);
}

}  // namespace adapters

inline boxplus::Plane3 native_value(const VertexPlane& v) {
  return adapters::plane(v.estimate());
}
inline boxplus::Line3 native_value(const VertexLine3D& v) {
  return adapters::line(v);
}

namespace internal {

template <>
struct MeasurementAdapter<Plane3D> {
  static constexpr int kSize = 4;
  using Native = boxplus::Plane3;
  static Native native(const Plane3D& z, const KeptMeasurement<Plane3D>&) { return adapters::plane(z); }
  static Plane3D to_g2o(const Native& z) { return Plane3D(z.coefficients); }
  static Plane3D from_data(const double* d) { return Plane3D(Vector4(d)); }
  static Vector4 to_data(const Plane3D& z, const KeptMeasurement<Plane3D>&) { return z.coeffs(); }
};

template <>
struct MeasurementAdapter<Line3D> {
  static constexpr int kSize = 6;
  using Native = boxplus::Line3;
  static Native native(const Line3D& z, const KeptMeasurement<Line3D>&) { return adapters::line(z); }
  static Line3D from_data(const double* d) { return Line3D(Vector6(d)); }
  static Vector6 to_data(const Line3D& z, const KeptMeasurement<Line3D>&) { return z; }
};

}  // namespace internal
}  // namespace g2o
