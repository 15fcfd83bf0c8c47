// SPDX-License-Identifier: BSD-3-Clause
// Points and poses of the plane as points and poses in space, with z = 0.
#pragma once

#include "g2o/types/slam2d/se2.h"

namespace g2o {
namespace internal {

inline Vector3 lift(const Vector2& p) {
  return {p.x(), p.y(), 0};
}

inline Isometry3 lift(const SE2& x) {
  Isometry3 pose = Isometry3::Identity();
  pose.linear() = AngleAxis(x.rotation().angle(), Vector3::UnitZ()).toRotationMatrix();
  pose.translation() = lift(x.translation());
  return pose;
}

}  // namespace internal
}  // namespace g2o
