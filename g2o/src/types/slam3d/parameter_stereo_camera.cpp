// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/parameter_stereo_camera.h"

#include "types/slam3d/adapters_slam3d.h"

namespace g2o {

ParameterStereoCamera::ParameterStereoCamera() = default;

bool ParameterStereoCamera::read(std::istream& is) {
  double baseline = 0;
  if (!ParameterCamera::read(is) || !adapters::read_value(is, 1, baseline)) return false;
  setBaseline(baseline);
  return true;
}

bool ParameterStereoCamera::write(std::ostream& os) const {
  return ParameterCamera::write(os) && adapters::write_rest(os, {_baseline});
}

}  // namespace g2o
