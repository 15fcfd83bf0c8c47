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
  registry.vertex<Segment2>("VERTEX_SEGMENT2D", "9 1 2 3 4");
  registry.vertex<Line2>("VERTEX_LINE2D", "10 0.5 2 -1 -1");
  registry.edge<SegmentObservation2, SE2, Segment2>("EDGE_SE2_SEGMENT2D", "0 9 1 2 3 4 1 0 0 0 1 0 0 1 0 1");
  registry.edge<SegmentLineObservation2, SE2, Segment2>("EDGE_SE2_SEGMENT2D_LINE", "0 9 0.5 2 1 0 1");
  registry.edge<SegmentEndObservation2, SE2, Segment2>("EDGE_SE2_SEGMENT2D_POINTLINE",
                                                       "0 9 1 3 4 0.5 1 0 0 1 0 1");
  registry.edge<LineObservation2, SE2, Line2>("EDGE_SE2_LINE2D", "0 10 0.5 2 1 0 1");
  registry.edge<LineDifference2, Line2, Line2>("EDGE_LINE2D", "10 11 0.25 1 1 0 1");
  registry.edge<PointToLine2, Line2, Vector2>("EDGE_LINE2D_POINTXY", "10 2 0.5 4");
}

}  // namespace boxplus
