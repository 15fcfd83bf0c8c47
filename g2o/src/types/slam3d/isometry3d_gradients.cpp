// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/isometry3d_gradients.h"

#include "boxplus/autodiff/dual.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace internal {
namespace {

boxplus::SE3 engine_pose(const Isometry3& x) {
  return {boxplus::Vector3(x.translation()), boxplus::Matrix<double, 3, 3>(x.linear())};
}

}  // namespace

void compute_dq_dR(Eigen::Matrix<double, 3, 9, Eigen::ColMajor>& dq_dR, const double& r11, const double& r21,
                   const double& r31, const double& r12, const double& r22, const double& r32,
                   const double& r13, const double& r23, const double& r33) {
  using S = boxplus::detail::Dual<double, 9>;
  const double entries[] = {r11, r21, r31, r12, r22, r32, r13, r23, r33};
  boxplus::Matrix<S, 3, 3> R;
  for (int i = 0; i < 9; ++i) R(i % 3, i / 3) = S::variable(entries[i], i);
  const boxplus::Vector<S, 3> q = boxplus::detail::QuaternionChart::log(boxplus::detail::quaternion_of(R));
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 9; ++k) dq_dR(i, k) = q[i].derivative[k];
  }
}

void edgeSE3Gradient(Isometry3& E, Matrix6& Ji, Matrix6& Jj, const Isometry3& Z, const Isometry3& Xi,
                     const Isometry3& Xj, const Isometry3& Pi, const Isometry3& Pj) {
  E = Z.inverse() * (Xi * Pi).inverse() * (Xj * Pj);
  adapters::linearize(boxplus::OffsetBetween<boxplus::SE3>(engine_pose(Z)),
                      adapters::Argument<boxplus::SE3>{engine_pose(Xi), Ji.data()},
                      adapters::Argument<boxplus::SE3>{engine_pose(Xj), Jj.data()},
                      adapters::Argument<boxplus::SE3>{engine_pose(Pi), nullptr},
                      adapters::Argument<boxplus::SE3>{engine_pose(Pj), nullptr});
}

void edgeSE3PriorGradient(Isometry3& E, Matrix6& J, const Isometry3& Z, const Isometry3& X,
                          const Isometry3& P) {
  E = Z.inverse() * X * P;
  adapters::linearize(boxplus::OffsetPrior<boxplus::SE3>(engine_pose(Z)),
                      adapters::Argument<boxplus::SE3>{engine_pose(X), J.data()},
                      adapters::Argument<boxplus::SE3>{engine_pose(P), nullptr});
}

}  // namespace internal
}  // namespace g2o
