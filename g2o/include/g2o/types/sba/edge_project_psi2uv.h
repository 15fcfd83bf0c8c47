// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTPSI2UV_H
#define G2O_SBA_EDGEPROJECTPSI2UV_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image position z (pixels) of a point in a camera. Another camera is the anchor of the point.
/// If p is the point in the frame of the anchor, the first vertex is ψ = (p_x/p_z, p_y/p_z, 1/p_z). The
/// second vertex is the camera T, and the third vertex is the anchor T_a. Error: z − cam(T T_a⁻¹ p). Tag:
/// EDGE_PROJECT_PSI2UV:EXPMAP, which g2o does not register.
class G2O_TYPES_SBA_API EdgeProjectPSI2UV
    : public ReadyMadeEdge<EdgeProjectPSI2UV, 2, Vector2, VertexPointXYZ, VertexSE3Expmap, VertexSE3Expmap> {
 public:
  EdgeProjectPSI2UV();

  CameraParameters* _cam = nullptr;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTPSI2UV_H
