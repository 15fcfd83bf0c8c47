// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTXYZ2UVU_H
#define G2O_SBA_EDGEPROJECTXYZ2UVU_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image coordinates z (pixels) of a point p in a stereo camera T: u, v, and u in the right
/// camera. Error: z − stereo(T p). Tag: EDGE_PROJECT_XYZ2UVU:EXPMAP.
class G2O_TYPES_SBA_API EdgeProjectXYZ2UVU
    : public ReadyMadeEdge<EdgeProjectXYZ2UVU, 3, Vector3, VertexPointXYZ, VertexSE3Expmap> {
 public:
  EdgeProjectXYZ2UVU();

  CameraParameters* _cam = nullptr;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTXYZ2UVU_H
