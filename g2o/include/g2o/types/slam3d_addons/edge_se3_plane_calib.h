// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_PLANE_CALIB_H
#define G2O_EDGE_SE3_PLANE_CALIB_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"

namespace g2o {

/// A plane z in the frame of a sensor on the robot x. The pose O of the sensor is a vertex, too. Vertices: x,
/// plane, O. Error: ((x O)⁻¹ plane).ominus(z). Tag: EDGE_SE3_PLANE_CALIB.
/// The measurement data are the four coefficients of the plane.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3PlaneSensorCalib
    : public ReadyMadeEdge<EdgeSE3PlaneSensorCalib, 3, Plane3D, VertexSE3, VertexPlane, VertexSE3> {
 public:
  EdgeSE3PlaneSensorCalib();

  Vector3 color = Vector3(0.1, 0.1, 0.1);  ///< red, green, blue in [0, 1]
};

/// The action "draw" of EdgeSE3PlaneSensorCalib.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3PlaneSensorCalibDrawAction
    : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3PlaneSensorCalibDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_PLANE_CALIB_H
