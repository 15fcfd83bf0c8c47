// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SE3_EULER_
#define G2O_VERTEX_SE3_EULER_

#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/g2o_types_slam3d_addons_api.h"

namespace g2o {

/// A VertexSE3 in the file format of TORO: x y z roll pitch yaw. Tag: VERTEX3.
class G2O_TYPES_SLAM3D_ADDONS_API VertexSE3Euler : public VertexSE3 {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};

}  // namespace g2o

#endif  // G2O_VERTEX_SE3_EULER_
