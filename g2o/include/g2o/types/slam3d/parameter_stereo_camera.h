// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_STEREO_CAMERA_PARAMETERS_H_
#define G2O_STEREO_CAMERA_PARAMETERS_H_

#include "g2o/types/slam3d/parameter_camera.h"

namespace g2o {

/// A stereo camera. The second camera is `baseline` meters to the right of the first camera.
/// Tag: PARAMS_STEREOCAMERACALIB.
class G2O_TYPES_SLAM3D_API ParameterStereoCamera : public ParameterCamera {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  ParameterStereoCamera();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  void setBaseline(double baseline) { _baseline = baseline; }
  double baseline() const { return _baseline; }

 protected:
  double _baseline = 0.075;
};

}  // namespace g2o

#endif  // G2O_STEREO_CAMERA_PARAMETERS_H_
