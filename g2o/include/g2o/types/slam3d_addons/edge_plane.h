// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PLANE_H
#define G2O_EDGE_PLANE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"

namespace g2o {

/// The measured difference z between the coefficients of two planes.
/// Error: (coefficients₂ − coefficients₁) − z. Tag: EDGE_PLANE.
class G2O_TYPES_SLAM3D_ADDONS_API EdgePlane
    : public ReadyMadeEdge<EdgePlane, 4, Vector4, VertexPlane, VertexPlane> {
 public:
  EdgePlane();
};

}  // namespace g2o

#endif  // G2O_EDGE_PLANE_H
