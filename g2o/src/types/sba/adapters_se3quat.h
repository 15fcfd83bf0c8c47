// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/types/ba/stereo_camera.h"
#include "g2o/core/factory.h"
#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/slam3d/se3quat.h"
#include "types/slam3d/adapters_slam3d.h"
#include "types/slam3d/cameras.h"

// Every source that includes this header refers to the source that registers the tags of all types. Without
// this, a linker would leave that source out of a program that links the static library.
G2O_USE_TYPE_GROUP(sba)
G2O_USE_TYPE_GROUP(expmap)

namespace g2o {
namespace adapters {

inline boxplus::SE3 pose(const SE3Quat& x) {
  return boxplus::SE3::from_unit(x.translation(),
                                 {x.rotation().x(), x.rotation().y(), x.rotation().z(), x.rotation().w()});
}
inline SE3Quat to_se3quat(const boxplus::SE3& x) {
  const boxplus::detail::Quaternion<double> q = x.quaternion();
  return SE3Quat(Quaternion(q.w, q.x, q.y, q.z), x.translation());
}
/// T x, as SE3Quat::map(). But the rotation of the engine is faster, because it keeps all values in
/// registers.
inline Vector3 transformed(const SE3Quat& T, const Vector3& x) {
  return pose(T) * x;
}

inline boxplus::StereoCamera camera(const CameraParameters& x) {
  return {{x.focal_length, x.principle_point[0], x.principle_point[1], x.baseline}};
}

}  // namespace adapters

namespace internal {

template <>
struct MeasurementAdapter<SE3Quat> {
  static constexpr int kSize = 7;
  using Native = boxplus::SE3;
  static Native native(const SE3Quat& z, const KeptMeasurement<SE3Quat>&) { return adapters::pose(z); }
  static SE3Quat to_g2o(const Native& z) { return adapters::to_se3quat(z); }
  static SE3Quat from_data(const double* d) { return SE3Quat(Eigen::Map<const Vector7>(d)); }
  static Vector7 to_data(const SE3Quat& z, const KeptMeasurement<SE3Quat>&) { return z.toVector(); }
};

}  // namespace internal
}  // namespace g2o
