// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_POINTXYZ_H
#define G2O_EDGE_POINTXYZ_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured difference z between the points p₂ and p₁. Error: (p₂ − p₁) − z. Tag: EDGE_POINTXYZ.
class G2O_TYPES_SLAM3D_API EdgePointXYZ
    : public ReadyMadeEdge<EdgePointXYZ, 3, Vector3, VertexPointXYZ, VertexPointXYZ> {
 public:
  EdgePointXYZ();
};

}  // namespace g2o

#endif  // G2O_EDGE_POINTXYZ_H
