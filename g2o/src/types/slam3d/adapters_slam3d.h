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

inline boxplus::SE3 native_value(const VertexSE3& v) {
  return adapters::pose(v);
}
inline boxplus::Vector3 native_value(const VertexPointXYZ& v) {
  return v.estimate();
}

namespace internal {

template <>
struct MeasurementAdapter<Isometry3> {
  using Kept = KeptMeasurement<Isometry3>;
  static constexpr int kSize = 7;
  using Native = boxplus::SE3;
  static Native native(const Isometry3& z, const Kept& kept) {
    return adapters::pose(z, kept.rotation_.get(z));
  }
  static Isometry3 to_g2o(const Native& z) { return adapters::to_g2o(z); }
  /// Keeps the digits of the quaternion in a file.
  static void remember(const Native& read, Isometry3& z, Kept& kept) {
    kept.rotation_.set(adapters::quaternion(read), z.linear());
  }
  static Isometry3 from_data(const double* d) { return fromVectorQT(Eigen::Map<const Vector7>(d)); }
  static Vector7 to_data(const Isometry3& z, const Kept& kept) {
    return Eigen::Map<const Vector7>(native(z, kept).data());
  }
};

}  // namespace internal
}  // namespace g2o
