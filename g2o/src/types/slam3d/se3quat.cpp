// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/se3quat.h"

#include <algorithm>
#include <cmath>

#include "boxplus/manifold/se3.h"

namespace g2o {
namespace {

/// The same tangent vector with the other order of its halves: the engine has (υ, ω).
Vector6 swapped(const Vector6& v) {
  Vector6 result;
  result << v.tail<3>(), v.head<3>();
  return result;
}

}  // namespace

void SE3Quat::fromMinimalVector(const Vector6& v) {
  const boxplus::detail::Quaternion<double> q = boxplus::detail::QuaternionChart::exp(v[3], v[4], v[5]);
  _r = Quaternion(q.w, q.x, q.y, q.z);
  _t = v.head<3>();
}

Vector6 SE3Quat::log() const {
  return swapped(boxplus::SE3::from_unit(_t, {_r.x(), _r.y(), _r.z(), _r.w()}).log());
}

SE3Quat SE3Quat::exp(const Vector6& update) {
  const boxplus::SE3 x = boxplus::SE3::exp(swapped(update));
  const boxplus::detail::Quaternion<double> q = x.quaternion();
  return SE3Quat(Quaternion(q.w, q.x, q.y, q.z), x.translation());
}

}  // namespace g2o
