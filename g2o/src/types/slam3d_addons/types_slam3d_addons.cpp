// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d_addons/types_slam3d_addons.h"

#include "g2o/core/factory.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(slam3d_addons);
G2O_USE_TYPE_GROUP(slam3d_addons_actions);

G2O_REGISTER_TYPE(VERTEX3, VertexSE3Euler);
G2O_REGISTER_TYPE(EDGE3, EdgeSE3Euler);
G2O_REGISTER_TYPE(VERTEX_PLANE, VertexPlane);
G2O_REGISTER_TYPE(EDGE_PLANE, EdgePlane);
G2O_REGISTER_TYPE(VERTEX_LINE3D, VertexLine3D);
G2O_REGISTER_TYPE(EDGE_SE3_LINE3D, EdgeSE3Line3D);
G2O_REGISTER_TYPE(EDGE_SE3_CALIB, EdgeSE3Calib);
G2O_REGISTER_TYPE(EDGE_SE3_PLANE_CALIB, EdgeSE3PlaneSensorCalib);

}  // namespace g2o
