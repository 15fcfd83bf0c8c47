// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_CALIB_H
#define G2O_EDGE_SE3_CALIB_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/g2o_types_slam3d_addons_api.h"

namespace g2o {

/// The motion z of a sensor between two robot poses x₁ and x₂. The pose c of the sensor on the robot is a
/// vertex, too. Vertices: x₁, x₂, c. Error: (t, q_v) of z⁻¹ (x₁ c)⁻¹ (x₂ c). Tag: EDGE_SE3_CALIB.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Calib
    : public ReadyMadeEdge<EdgeSE3Calib, 6, Isometry3, VertexSE3, VertexSE3, VertexSE3> {
 public:
  EdgeSE3Calib();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_CALIB_H
