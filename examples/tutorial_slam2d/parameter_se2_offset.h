// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/cache.h"
#include "vertex_se2.h"

namespace g2o {
namespace tutorial {

// [parameter]
/// The pose of the sensor on the robot. In a file: TUTORIAL_PARAMS_SE2_OFFSET id x y θ
class ParameterSE2Offset : public Parameter {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  const SE2& offset() const { return _offset; }
  void setOffset(const SE2& offset) { _offset = offset; }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

 protected:
  SE2 _offset;
};

/// The pose of the sensor in the world for one pose of the robot. All edges of this pose use the same cache,
/// so the pose of the sensor is computed only once. Tag: TUTORIAL_CACHE_SE2_OFFSET.
class CacheSE2Offset : public Cache {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  const SE2& sensorToWorld() const { return _sensorToWorld; }
  const SE2& worldToSensor() const { return _worldToSensor; }
  const ParameterSE2Offset* offsetParam() const { return _offsetParam; }

 protected:
  bool resolveDependencies() override;
  void updateImpl() override;

  const ParameterSE2Offset* _offsetParam = nullptr;
  SE2 _sensorToWorld, _worldToSensor;
};
// [/parameter]

}  // namespace tutorial
}  // namespace g2o
