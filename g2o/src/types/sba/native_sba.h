// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/factory.h"
#include "g2o/types/slam3d/se3quat.h"
#include "types/slam3d/native_slam3d.h"

// Who uses a type gets the words of all: of a static library, linkers take only what is referred to.
G2O_USE_TYPE_GROUP(sba)
G2O_USE_TYPE_GROUP(expmap)

namespace g2o {
namespace native {

inline boxplus::SE3 pose(const SE3Quat& x) {
  return boxplus::SE3::from_unit(x.translation(),
                                 {x.rotation().x(), x.rotation().y(), x.rotation().z(), x.rotation().w()});
}
inline SE3Quat to_quaternion_face(const boxplus::SE3& x) {
  const boxplus::Quaternion<double> q = x.quaternion();
  return SE3Quat(Quaternion(q.w, q.x, q.y, q.z), x.translation());
}

}  // namespace native
}  // namespace g2o
