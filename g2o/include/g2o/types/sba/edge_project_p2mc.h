// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTP2MC_H
#define G2O_SBA_EDGEPROJECTP2MC_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_cam.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image position z (pixels) of a point in a camera. Error: (u, v) − z.
/// Tag: EDGE_PROJECT_P2MC.
class G2O_TYPES_SBA_API EdgeProjectP2MC
    : public ReadyMadeEdge<EdgeProjectP2MC, 2, Vector2, VertexPointXYZ, VertexCam> {
 public:
  EdgeProjectP2MC();
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTP2MC_H
