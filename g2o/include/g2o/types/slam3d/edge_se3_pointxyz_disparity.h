// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PROJECT_DISPARITY_H_
#define G2O_EDGE_PROJECT_DISPARITY_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_camera.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured image position (pixels) and inverse depth (1/meters) of a point, z = (u, v, 1/depth), in a
/// camera on a robot. Error: (u, v, 1/depth) − z. Tag: EDGE_PROJECT_DISPARITY.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDisparity
    : public ReadyMadeEdge<EdgeSE3PointXYZDisparity, 3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EdgeSE3PointXYZDisparity();

  const ParameterCamera* cameraParameter() const { return params; }

 protected:
  ParameterCamera* params = nullptr;
};

/// The action "draw" of EdgeSE3PointXYZDisparity.
class G2O_TYPES_SLAM3D_API EdgeProjectDisparityDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeProjectDisparityDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_PROJECT_DISPARITY_H_
