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
}  // namespace g2o
