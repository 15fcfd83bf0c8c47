// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {

void register_slam2d(Registry& registry) {
  registry.vertex<SE2>("VERTEX_SE2");
  registry.vertex<Vector2>("VERTEX_XY");
  registry.vertex<DifferentialDrive>("VERTEX_ODOM_DIFFERENTIAL");
  registry.parameter<SE2>("PARAMS_SE2OFFSET");
  registry.edge<Between<SE2>, SE2, SE2>("EDGE_SE2");
  registry.edge<PointObservation2, SE2, Vector2>("EDGE_SE2_XY");
  registry.edge<BearingObservation2, SE2, Vector2>("EDGE_BEARING_SE2_XY");
  registry.edge<Prior<SE2>, SE2>("EDGE_PRIOR_SE2");
  registry.edge<PositionPrior<Vector2>, SE2>("EDGE_PRIOR_SE2_XY");
  registry.edge<Prior<Vector2>, Vector2>("EDGE_PRIOR_XY");
  registry.edge<Between<Vector2>, Vector2, Vector2>("EDGE_POINTXY");
  registry.edge<OffsetPointObservation2, SE2, Vector2, Parameter<SE2>>("EDGE_SE2_POINTXY_OFFSET");
  registry.edge<OffsetPointObservation2, SE2, Vector2, SE2>("EDGE_SE2_XY_CALIB");
  registry.edge<OffsetBetween<SE2>, SE2, SE2, Parameter<SE2>, Parameter<SE2>>("EDGE_SE2_OFFSET");
  registry.edge_with_shared_parameter<OffsetBetween<SE2>, SE2, SE2, Parameter<SE2>>("EDGE_SE2_OFFSET");
  registry.edge<OffsetBetween<SE2>, SE2, SE2, SE2>("EDGE_SE2_CALIB");
  registry.edge<WheelOdometry, SE2, SE2, DifferentialDrive>("EDGE_SE2_ODOM_DIFFERENTIAL_CALIB");
  registry.edge<TwoPointsObservation2, SE2, Vector2, Vector2>("EDGE_SE2_TWOPOINTSXY");
  registry.edge<PointsObservation2, SE2, Tail<Vector2>>("EDGE_SE2_LOTSOFXY");
}

}  // namespace boxplus
