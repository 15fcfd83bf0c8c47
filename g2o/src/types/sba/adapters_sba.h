// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/types/sba/vertex_cam.h"
#include "types/sba/adapters_se3quat.h"

namespace g2o {

inline boxplus::SE3 native_value(const VertexCam& v) {
  return adapters::pose(v.estimate());
}

}  // namespace g2o
