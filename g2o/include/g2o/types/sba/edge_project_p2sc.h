// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTP2SC_H
#define G2O_SBA_EDGEPROJECTP2SC_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_cam.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image coordinates z (pixels) of a point in a stereo camera: u, v, and u in the right camera.
/// Error: (u, v, u_right) − z. Tag: EDGE_PROJECT_P2SC.
class G2O_TYPES_SBA_API EdgeProjectP2SC
    : public ReadyMadeEdge<EdgeProjectP2SC, 3, Vector3, VertexPointXYZ, VertexCam> {
 public:
  EdgeProjectP2SC();
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTP2SC_H
