// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/model_pose.h"

#include "boxplus/manifold/quaternion.h"

namespace boxplus {

SE3 pose_of(const SparseModel::Pose& pose) {
  const auto& q = pose.rotation;
  const SO3 rotation(detail::Quaternion<double>{q[1], q[2], q[3], q[0]});
  return SE3(Vector3(pose.translation.data()), rotation).inverse();
}

SparseModel::Pose pose_in_file(const SE3& pose) {
  const SE3 inverse = pose.inverse();
  const detail::Quaternion<double> q = inverse.quaternion();
  const Vector3 positive_zero(0, 0, 0), t = inverse.translation() + positive_zero;
  return {{q.w, q.x, q.y, q.z}, {t[0], t[1], t[2]}};
}

SE3 pose_of(const SparseModel::Image& image) {
  return pose_of(SparseModel::Pose{image.rotation, image.translation});
}

}  // namespace boxplus
