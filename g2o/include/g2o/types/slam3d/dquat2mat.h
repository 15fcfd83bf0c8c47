// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_DQUAT2MAT_H
#define G2O_DQUAT2MAT_H

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/g2o_types_slam3d_api.h"

namespace g2o {
namespace internal {

/// Computes the derivatives of q_v, the vector part of the unit quaternion (w ≥ 0) of a rotation matrix R,
/// with respect to the nine entries of R, by columns. The derivatives are exact for changes that keep R a
/// rotation.
G2O_TYPES_SLAM3D_API void compute_dq_dR(Eigen::Matrix<double, 3, 9, Eigen::ColMajor>& dq_dR,
                                        const double& r11, const double& r21, const double& r31,
                                        const double& r12, const double& r22, const double& r32,
                                        const double& r13, const double& r23, const double& r33);

}  // namespace internal
}  // namespace g2o

#endif  // G2O_DQUAT2MAT_H
