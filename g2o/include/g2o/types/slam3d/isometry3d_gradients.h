// SPDX-License-Identifier: BSD-3-Clause
// Errors and Jacobians of edges for 3-D poses. The error is (t, q_v): the translation of a motion E and the
// vector part of its unit quaternion with w ≥ 0. The Jacobians are derivatives with respect to the increment
// (⊞) of VertexSE3.
#pragma once
#ifndef G2O_ISOMETRY3D_GRADIENTS_H_
#define G2O_ISOMETRY3D_GRADIENTS_H_

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/dquat2mat.h"
#include "g2o/types/slam3d/g2o_types_slam3d_api.h"
#include "g2o/types/slam3d/isometry3d_mappings.h"

namespace g2o {
namespace internal {

G2O_TYPES_SLAM3D_API void edgeSE3Gradient(Isometry3& E, Matrix6& Ji, Matrix6& Jj, const Isometry3& Z,
                                          const Isometry3& Xi, const Isometry3& Xj, const Isometry3& Pi,
                                          const Isometry3& Pj);
G2O_TYPES_SLAM3D_API void edgeSE3PriorGradient(Isometry3& E, Matrix6& J, const Isometry3& Z,
                                               const Isometry3& X, const Isometry3& P);

/// Computes E = Z⁻¹ (Xi Pi)⁻¹ (Xj Pj), and the derivatives of the error (t, q_v) with respect to the
/// increments of Xi and Xj.
template <typename DerivedI, typename DerivedJ>
void computeEdgeSE3Gradient(Isometry3& E, const Eigen::MatrixBase<DerivedI>& JiConstRef,
                            const Eigen::MatrixBase<DerivedJ>& JjConstRef, const Isometry3& Z,
                            const Isometry3& Xi, const Isometry3& Xj,
                            const Isometry3& Pi = Isometry3::Identity(),
                            const Isometry3& Pj = Isometry3::Identity()) {
  Matrix6 Ji, Jj;
  edgeSE3Gradient(E, Ji, Jj, Z, Xi, Xj, Pi, Pj);
  const_cast<Eigen::MatrixBase<DerivedI>&>(JiConstRef) = Ji;
  const_cast<Eigen::MatrixBase<DerivedJ>&>(JjConstRef) = Jj;
}

/// Computes E = Z⁻¹ X P, and the derivative of the error (t, q_v) with respect to the increment of X.
template <typename Derived>
void computeEdgeSE3PriorGradient(Isometry3& E, const Eigen::MatrixBase<Derived>& JConstRef,
                                 const Isometry3& Z, const Isometry3& X,
                                 const Isometry3& P = Isometry3::Identity()) {
  Matrix6 J;
  edgeSE3PriorGradient(E, J, Z, X, P);
  const_cast<Eigen::MatrixBase<Derived>&>(JConstRef) = J;
}

}  // namespace internal
}  // namespace g2o

#endif  // G2O_ISOMETRY3D_GRADIENTS_H_
