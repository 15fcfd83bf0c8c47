// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/se3quat.h"

#include <algorithm>
#include <cmath>

#include "boxplus/manifold/rotation_charts.h"
#include "boxplus/manifold/sim3_exponential.h"
#include "g2o/types/slam3d/isometry3d_mappings.h"

namespace g2o {
namespace {

/// The matrix V of the exponential map of SE(3). It is the matrix V of Sim(3) for the scale 1, whose
/// logarithm is 0.
boxplus::detail::Sim3Coupling<double> coupling(const Vector3& omega) {
  return boxplus::detail::Sim3Coupling<double>::of(0, omega.squaredNorm());
}

}  // namespace

void SE3Quat::fromMinimalVector(const Vector6& v) {
  const boxplus::detail::Quaternion<double> q = boxplus::detail::QuaternionChart::exp(v[3], v[4], v[5]);
  _r = Quaternion(q.w, q.x, q.y, q.z);
  _t = v.head<3>();
}

Vector6 SE3Quat::log() const {
  const boxplus::Vector3 omega = boxplus::detail::RotationVectorChart::log(
      boxplus::detail::Quaternion<double>{_r.x(), _r.y(), _r.z(), _r.w()});
  Vector6 v;
  v << omega, coupling(omega).inverse(omega.squaredNorm()).apply(omega, _t);
  return v;
}

SE3Quat SE3Quat::exp(const Vector6& update) {
  const boxplus::Vector3 omega = update.head<3>(), upsilon = update.tail<3>();
  const boxplus::detail::Quaternion<double> q =
      boxplus::detail::RotationVectorChart::exp(omega[0], omega[1], omega[2]);
  return SE3Quat(Quaternion(q.w, q.x, q.y, q.z), Vector3(coupling(omega).apply(omega, upsilon)));
}

namespace internal {

SE3Quat toSE3Quat(const Isometry3& t) {
  return SE3Quat(Matrix3(t.linear()), Vector3(t.translation()));
}

Isometry3 fromSE3Quat(const SE3Quat& t) {
  return t;
}

}  // namespace internal
}  // namespace g2o
