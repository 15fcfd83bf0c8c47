// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_CAMERAPARAMETERS_H
#define G2O_SBA_CAMERAPARAMETERS_H

#include "g2o/core/eigen_types.h"
#include "g2o/core/parameter.h"
#include "g2o/types/sba/g2o_types_sba_api.h"

namespace g2o {

/// The intrinsics of a camera with one focal length, and the baseline (meters) to a second camera on its
/// right. Tag: PARAMS_CAMERAPARAMETERS.
class G2O_TYPES_SBA_API CameraParameters : public Parameter {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  CameraParameters();
  CameraParameters(double focalLength, const Vector2& principlePoint, double baseLine);

  /// Project a point in the frame of the camera to (u, v), or to (u, v, u_right). u_right is the coordinate u
  /// in the right image.
  Vector2 cam_map(const Vector3& trans_xyz) const;
  Vector3 stereocam_uvu_map(const Vector3& trans_xyz) const;

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  double focal_length = 1;
  Vector2 principle_point = Vector2(0, 0);
  double baseline = 0.5;
};

}  // namespace g2o

#endif  // G2O_SBA_CAMERAPARAMETERS_H
