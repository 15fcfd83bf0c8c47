// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SE3_OFFSET_PARAMETERS_H_
#define G2O_VERTEX_SE3_OFFSET_PARAMETERS_H_

#include "g2o/core/cache.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The pose of a sensor on a robot. Tag: PARAMS_SE3OFFSET.
class G2O_TYPES_SLAM3D_API ParameterSE3Offset : public Parameter {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  ParameterSE3Offset();
  ~ParameterSE3Offset() override;

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  void setOffset(const Isometry3& offset = Isometry3::Identity());
  const Isometry3& offset() const { return _offset; }
  const Isometry3& inverseOffset() const { return _inverseOffset; }
  /// Returns the quaternion of the offset (see internal::RotationMemory).
  internal::RotationMemory::Coefficients quaternion() const { return rotation_.get(_offset); }

 protected:
  Isometry3 _offset;
  Isometry3 _inverseOffset;

 private:
  internal::RotationMemory rotation_;
};

/// The pose of a sensor in the world, for one pose of the robot. n2w() transforms from the sensor frame to
/// the world frame, w2n() from the world frame to the sensor frame, and w2l() from the world frame to the
/// robot frame.
class G2O_TYPES_SLAM3D_API CacheSE3Offset : public Cache {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  CacheSE3Offset();
  ~CacheSE3Offset() override;
  void updateImpl() override;

  const ParameterSE3Offset* offsetParam() const { return _offsetParam; }
  void setOffsetParam(ParameterSE3Offset* offsetParam) { _offsetParam = offsetParam; }
  const Isometry3& w2n() const { return _w2n; }
  const Isometry3& n2w() const { return _n2w; }
  const Isometry3& w2l() const { return _w2l; }

 protected:
  bool resolveDependencies() override;

  ParameterSE3Offset* _offsetParam = nullptr;
  Isometry3 _w2n, _n2w, _w2l;
};

/// The action "draw" of CacheSE3Offset.
class G2O_TYPES_SLAM3D_API CacheSE3OffsetDrawAction : public internal::NamedAction<DrawAction> {
 public:
  CacheSE3OffsetDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_SE3_OFFSET_PARAMETERS_H_
