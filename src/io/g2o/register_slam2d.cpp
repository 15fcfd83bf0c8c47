// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {

void register_slam2d(Registry& registry) {
  registry.vertex<SE2>("VERTEX_SE2", "1 1 0.1 0.5");
  registry.vertex<Vector2>("VERTEX_XY", "2 2 3");
  registry.vertex<DifferentialDrive>("VERTEX_ODOM_DIFFERENTIAL", "8 1 1 0.5");
  registry.parameter<SE2>("PARAMS_SE2OFFSET", "5 1 0 0.25");
  registry.edge<Between<SE2>, SE2, SE2>("EDGE_SE2", "0 1 1 0 0.5 1 0.5 0 2 0 3");
  registry.edge<PointObservation2, SE2, Vector2>("EDGE_SE2_XY", "0 2 2 3 1 0 1");
  registry.edge<BearingObservation2, SE2, Vector2>("EDGE_BEARING_SE2_XY", "0 2 0.5 100");
  registry.edge<Prior<SE2>, SE2>("EDGE_PRIOR_SE2", "1 1 0 0.5 1 0 0 1 0 1");
  registry.edge<PositionPrior<Vector2>, SE2>("EDGE_PRIOR_SE2_XY", "1 1 0 1 0 1");
  registry.edge<Prior<Vector2>, Vector2>("EDGE_PRIOR_XY", "2 1 0 1 0 1");
  registry.edge<Between<Vector2>, Vector2, Vector2>("EDGE_POINTXY", "2 3 0 1 1 0 1");
  registry.edge<OffsetPointObservation2, SE2, Vector2, Parameter<SE2>>("EDGE_SE2_POINTXY_OFFSET",
                                                                       "1 2 5 1 1 1 0 1");
  registry.edge<OffsetPointObservation2, SE2, Vector2, SE2>("EDGE_SE2_XY_CALIB", "1 2 4 1 1 1 0 1");
  registry.edge<OffsetBetween<SE2>, SE2, SE2, Parameter<SE2>, Parameter<SE2>>("EDGE_SE2_OFFSET",
                                                                              "0 1 5 6 1 0 0.5 1 0 0 1 0 1");
  registry.edge_with_shared_parameter<OffsetBetween<SE2>, SE2, SE2, Parameter<SE2>>(
      "EDGE_SE2_OFFSET", "0 1 5 5 1 0 0.5 1 0 0 1 0 1");
  registry.edge<OffsetBetween<SE2>, SE2, SE2, SE2>("EDGE_SE2_CALIB", "0 1 4 1 0 0.5 1 0 0 1 0 1");
  registry.edge<WheelOdometry, SE2, SE2, DifferentialDrive>("EDGE_SE2_ODOM_DIFFERENTIAL_CALIB",
                                                            "0 1 8 1 2 0.1 1 0 0 1 0 1");
  registry.edge<TwoPointsObservation2, SE2, Vector2, Vector2>("EDGE_SE2_TWOPOINTSXY",
                                                              "0 2 3 1 2 3 4 1 0 0 0 1 0 0 1 0 1");
  registry.edge<PointsObservation2, SE2, Tail<Vector2>>("EDGE_SE2_LOTSOFXY",
                                                        "0 2 3 || 2 1 2 3 4 1 0 0 0 1 0 0 1 0 1");
}

}  // namespace boxplus
