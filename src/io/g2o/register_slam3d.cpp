// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {

void register_slam3d(Registry& registry) {
  registry.vertex<SE3>("VERTEX_SE3:QUAT", "1 1 2 3 0 0 0.6 0.8");
  registry.vertex<Vector3>("VERTEX_TRACKXYZ", "2 1 1 2");
  registry.old_vertex<Vector3>("VERTEX_XYZ", "2 1 1 2");
  registry.parameter<SE3>("PARAMS_SE3OFFSET", "5 0 0 1 0 0.6 0 0.8");
  registry.edge<Between<SE3>, SE3, SE3>("EDGE_SE3:QUAT",
                                        "0 1 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<OffsetPointObservation3, SE3, Vector3, Parameter<SE3>>("EDGE_SE3_TRACKXYZ",
                                                                       "0 2 5 1 2 3 1 0 0 1 0 1");
  registry.edge<OffsetPrior<SE3>, SE3, Parameter<SE3>>(
      "EDGE_SE3_PRIOR", "1 5 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<PositionPrior<Vector3>, SE3, Parameter<SE3>>("EDGE_SE3_XYZ_PRIOR", "1 5 1 2 3 1 0 0 1 0 1");
  registry.edge<OffsetBetween<SE3>, SE3, SE3, Parameter<SE3>, Parameter<SE3>>(
      "EDGE_SE3_OFFSET", "0 1 5 6 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge_with_shared_parameter<OffsetBetween<SE3>, SE3, SE3, Parameter<SE3>>(
      "EDGE_SE3_OFFSET", "0 1 5 5 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<Between<Vector3>, Vector3, Vector3>("EDGE_POINTXYZ", "2 3 0 0 1 1 0 0 1 0 1");
  registry.edge<Prior<Vector3>, Vector3>("EDGE_POINTXYZ_PRIOR", "2 1 1 1 1 0 0 1 0 1");
  registry.edge<PointsObservation3, SE3, Tail<Vector3>>(
      "EDGE_SE3_LOTSOF_XYZ", "0 2 3 || 2 1 2 3 4 5 6 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.edge<OffsetBetween<SE3>, SE3, SE3, SE3>(
      "EDGE_SE3_CALIB", "0 1 4 1 2 3 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1");
  registry.vertex<Plane3>("VERTEX_PLANE", "9 0.6 0 0.8 -2 0.2 0.2 0.2");
  registry.edge<PlaneObservation3, SE3, Plane3, SE3>("EDGE_SE3_PLANE_CALIB",
                                                     "0 9 4 0.6 0.8 0 -1 0.1 0.1 0.1 1 0 0 1 0 1");
  registry.edge<PlaneDifference3, Plane3, Plane3>("EDGE_PLANE", "9 10 0 0.5 0 1 1 0 0 0 1 0 0 1 0 1");
  registry.vertex<Line3>("VERTEX_LINE3D", "11 0 -3 0 0.6 0 0.8");
  registry.edge<LineObservation3, SE3, Line3, Parameter<SE3>>("EDGE_SE3_LINE3D",
                                                              "0 11 5 1 0 -2 0 1 0 1 0 0 0 1 0 0 1 0 1");
}

}  // namespace boxplus
