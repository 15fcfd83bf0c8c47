// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_CAMERA_PARAMETERS_H_
#define G2O_CAMERA_PARAMETERS_H_

#include "g2o/types/slam3d/parameter_se3_offset.h"

namespace g2o {

/// The pose of a camera on a robot, and the camera matrix K. Tag: PARAMS_CAMERACALIB.
class G2O_TYPES_SLAM3D_API ParameterCamera : public ParameterSE3Offset {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  ParameterCamera();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  void setKcam(double fx, double fy, double cx, double cy);
  /// Hides setOffset() of the base class, because this function also updates Kcam_inverseOffsetR().
  void setOffset(const Isometry3& offset = Isometry3::Identity());

  const Matrix3& Kcam() const { return _Kcam; }
  const Matrix3& invKcam() const { return _invKcam; }
  /// Returns K times the rotation of the inverse offset.
  const Matrix3& Kcam_inverseOffsetR() const { return _Kcam_inverseOffsetR; }

 protected:
  Matrix3 _Kcam = Matrix3::Identity();
  Matrix3 _invKcam = Matrix3::Identity();
  Matrix3 _Kcam_inverseOffsetR = Matrix3::Identity();
};

/// The pose of a camera in the world, for one pose of the robot. Also has the projection w2i = K w2n from the
/// world frame to the image.
class G2O_TYPES_SLAM3D_API CacheCamera : public CacheSE3Offset {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  CacheCamera();
  void updateImpl() override;

  const ParameterCamera* camParams() const { return params; }
  const Affine3& w2i() const { return _w2i; }

 protected:
  bool resolveDependencies() override;

  ParameterCamera* params = nullptr;
  Affine3 _w2i = Affine3::Identity();
};

/// The action "draw" of CacheCamera.
class G2O_TYPES_SLAM3D_API CacheCameraDrawAction : public internal::NamedAction<DrawAction> {
 public:
  CacheCameraDrawAction();
};

}  // namespace g2o

#endif  // G2O_CAMERA_PARAMETERS_H_
