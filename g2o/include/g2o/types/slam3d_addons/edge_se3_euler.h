// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_EULER_
#define G2O_EDGE_SE3_EULER_

#include "g2o/types/slam3d/edge_se3.h"
#include "g2o/types/slam3d_addons/g2o_types_slam3d_addons_api.h"

namespace g2o {

/// An EdgeSE3 in the file format of TORO: x y z roll pitch yaw, then Ω for small errors of these six values.
/// The rotation error of EdgeSE3 is half the angle. Therefore, read() multiplies the rotation rows of Ω by
/// two, and then the rotation columns. Tag: EDGE3.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Euler : public EdgeSE3 {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_EULER_
