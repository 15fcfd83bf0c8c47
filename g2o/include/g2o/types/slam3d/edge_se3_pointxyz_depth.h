// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PROJECT_DEPTH_H_
#define G2O_EDGE_PROJECT_DEPTH_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_camera.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured image position (pixels) and depth (meters) of a point, z = (u, v, depth), in a camera on a
/// robot. Error: (u, v, depth) − z. Tag: EDGE_PROJECT_DEPTH.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDepth
    : public ReadyMadeEdge<EdgeSE3PointXYZDepth, 3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EdgeSE3PointXYZDepth();

  const ParameterCamera* cameraParameter() const { return params; }

 protected:
  ParameterCamera* params = nullptr;
};

}  // namespace g2o

#endif  // G2O_EDGE_PROJECT_DEPTH_H_
