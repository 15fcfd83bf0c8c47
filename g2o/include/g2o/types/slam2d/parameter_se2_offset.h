// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SE2_OFFSET_PARAMETERS_H_
#define G2O_VERTEX_SE2_OFFSET_PARAMETERS_H_

#include "g2o/core/cache.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The pose of a sensor on a robot. Tag: PARAMS_SE2OFFSET.
class G2O_TYPES_SLAM2D_API ParameterSE2Offset : public Parameter {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  ParameterSE2Offset();
  ~ParameterSE2Offset() override;

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  void setOffset(const SE2& offset = SE2());
  const SE2& offset() const { return _offset; }
  const Isometry2& offsetMatrix() const { return _offsetMatrix; }
  const Isometry2& inverseOffsetMatrix() const { return _inverseOffsetMatrix; }

 protected:
  SE2 _offset;
  Isometry2 _offsetMatrix, _inverseOffsetMatrix;
};

/// The pose of a sensor in the world, for one pose of the robot. n2w() transforms from the sensor frame to
/// the world frame, w2n() from the world frame to the sensor frame, and w2l() from the world frame to the
/// robot frame.
class G2O_TYPES_SLAM2D_API CacheSE2Offset : public Cache {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  CacheSE2Offset();
  ~CacheSE2Offset() override;
  void updateImpl() override;

  const ParameterSE2Offset* offsetParam() const { return _offsetParam; }
  void setOffsetParam(ParameterSE2Offset* offsetParam) { _offsetParam = offsetParam; }
  const SE2& w2n() const { return _se2_w2n; }
  const SE2& n2w() const { return _se2_n2w; }
  const Isometry2& w2nMatrix() const { return _w2n; }
  const Isometry2& n2wMatrix() const { return _n2w; }
  const Isometry2& w2lMatrix() const { return _w2l; }

 protected:
  bool resolveDependencies() override;

  ParameterSE2Offset* _offsetParam = nullptr;
  SE2 _se2_w2n, _se2_n2w;
  Isometry2 _w2n, _n2w, _w2l;
};

}  // namespace g2o

#endif  // G2O_VERTEX_SE2_OFFSET_PARAMETERS_H_
