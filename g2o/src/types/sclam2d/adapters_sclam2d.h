// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/factory.h"
#include "g2o/types/sclam2d/odometry_measurement.h"
#include "g2o/types/sclam2d/vertex_odom_differential_params.h"
#include "types/slam2d/adapters_slam2d.h"

G2O_USE_TYPE_GROUP(sclam)  // registers the tags for clients that use only these types

namespace g2o {
namespace adapters {

inline boxplus::WheelSpeeds speeds(const VelocityMeasurement& v) {
  return {v.vl(), v.vr(), v.dt()};
}
inline VelocityMeasurement to_g2o(const boxplus::WheelSpeeds& v) {
  return {v.left, v.right, v.duration};
}
inline boxplus::DifferentialDrive drive(const Vector3& k) {
  return {k[0], k[1], k[2]};
}
inline boxplus::DifferentialDrive drive(const VertexOdomDifferentialParams& v) {
  return drive(v.estimate());
}
inline Vector3 to_g2o(const boxplus::DifferentialDrive& k) {
  return {k.left_factor, k.right_factor, k.baseline};
}

}  // namespace adapters

inline boxplus::DifferentialDrive native_value(const VertexOdomDifferentialParams& v) {
  return adapters::drive(v);
}

namespace internal {

template <>
struct MeasurementAdapter<VelocityMeasurement> {
  using Kept = KeptMeasurement<VelocityMeasurement>;
  static constexpr int kSize = 3;
  using Native = boxplus::WheelSpeeds;
  static Native native(const VelocityMeasurement& z, const Kept&) { return adapters::speeds(z); }
  static VelocityMeasurement to_g2o(const Native& z) { return adapters::to_g2o(z); }
  static VelocityMeasurement from_data(const double* d) { return {d[0], d[1], d[2]}; }
  static Vector3 to_data(const VelocityMeasurement& z, const Kept&) { return {z.vl(), z.vr(), z.dt()}; }
};

}  // namespace internal
}  // namespace g2o
