// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/factory.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"
#include "g2o/types/slam2d_addons/vertex_segment2d.h"
#include "types/slam2d/adapters_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d_segment)  // registers the tags for clients that use only these types

namespace g2o {
namespace adapters {

inline boxplus::Segment2 segment(const Vector4& ends) {
  return {ends.head<2>(), ends.tail<2>()};
}
inline boxplus::Segment2 segment(const VertexSegment2D& v) {
  return segment(v.estimate());
}
inline boxplus::Line2 line(const VertexLine2D& v) {
  return {v.theta(), v.rho(), {v.p1Id, v.p2Id}};
}

}  // namespace adapters

inline boxplus::Segment2 native_value(const VertexSegment2D& v) {
  return adapters::segment(v);
}
inline boxplus::Line2 native_value(const VertexLine2D& v) {
  return adapters::line(v);
}

}  // namespace g2o
