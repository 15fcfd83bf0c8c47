// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTP2MC_H
#define G2O_SBA_EDGEPROJECTP2MC_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/sba/vertex_cam.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image position z (pixels) of a point in a camera. Error: (u, v) − z.
/// Tag: EDGE_PROJECT_P2MC.
class G2O_TYPES_SBA_API EdgeProjectP2MC : public BaseBinaryEdge<2, Vector2, VertexPointXYZ, VertexCam> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeProjectP2MC();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<2, Vector2, VertexPointXYZ, VertexCam>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTP2MC_H
