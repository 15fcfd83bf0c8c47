// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/types/slam3d.h"
#include "g2o/core/factory.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "types/adapters.h"

// Every source that includes this header refers to the source that registers the tags of all types. Without
// this, a linker would leave that source out of a program that links the static library.
G2O_USE_TYPE_GROUP(slam3d)

namespace g2o {
namespace adapters {

inline boxplus::SE3 pose(const Isometry3& x, const internal::RotationMemory::Coefficients& q) {
  return boxplus::SE3::from_unit(x.translation(), {q[0], q[1], q[2], q[3]});
}
inline boxplus::SE3 pose(const VertexSE3& v) {
  return pose(v.estimate(), v.quaternion());
}
inline boxplus::SE3 pose(const ParameterSE3Offset& p) {
  return pose(p.offset(), p.quaternion());
}
inline internal::RotationMemory::Coefficients quaternion(const boxplus::SE3& x) {
  return {x.data()[3], x.data()[4], x.data()[5], x.data()[6]};
}
inline boxplus::Vector3 point(const Vector3& p) {
  return p;
}
inline boxplus::Vector3 point(const VertexPointXYZ& v) {
  return v.estimate();
}
inline Isometry3 to_g2o(const boxplus::SE3& x) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = x.rotation();
  pose.translation() = x.translation();
  return pose;
}

}  // namespace adapters
}  // namespace g2o
