// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTXYZ2UV_H
#define G2O_SBA_EDGEPROJECTXYZ2UV_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image position z (pixels) of a point p in a camera T. Error: z − cam(T p).
/// Tag: EDGE_PROJECT_XYZ2UV:EXPMAP.
class G2O_TYPES_SBA_API EdgeProjectXYZ2UV
    : public ReadyMadeEdge<EdgeProjectXYZ2UV, 2, Vector2, VertexPointXYZ, VertexSE3Expmap> {
 public:
  EdgeProjectXYZ2UV();

  CameraParameters* _cam = nullptr;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTXYZ2UV_H
