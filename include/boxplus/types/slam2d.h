// SPDX-License-Identifier: BSD-3-Clause
// All ready-made types in the plane. Their pools are compiled once, in the library.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/types/between.h"
#include "boxplus/types/offset_between.h"
#include "boxplus/types/position_prior.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/range.h"
#include "boxplus/types/slam2d/bearing_observation.h"
#include "boxplus/types/slam2d/differential_drive.h"
#include "boxplus/types/slam2d/line.h"
#include "boxplus/types/slam2d/point_observation.h"
#include "boxplus/types/slam2d/points_observation.h"
#include "boxplus/types/slam2d/segment.h"
#include "boxplus/types/slam2d/wheel_odometry.h"

namespace boxplus::detail {

extern template class TypedVertexPool<DifferentialDrive>;
extern template class TypedEdgePool<PositionPrior<Vector2>, SE2>;
extern template class TypedEdgePool<OffsetBetween<SE2>, SE2, SE2, SE2>;
extern template class TypedEdgePool<OffsetBetween<SE2>, SE2, SE2, SE2, SE2>;
extern template class TypedEdgePool<PointObservation2, SE2, Vector2>;
extern template class TypedEdgePool<OffsetPointObservation2, SE2, Vector2, SE2>;
extern template class TypedEdgePool<TwoPointsObservation2, SE2, Vector2, Vector2>;
extern template class TypedEdgePool<PointsObservation2, SE2, Tail<Vector2>>;
extern template class TypedEdgePool<BearingObservation2, SE2, Vector2>;
extern template class TypedEdgePool<Range, SE2, Vector2>;
extern template class TypedEdgePool<WheelOdometry, SE2, SE2, DifferentialDrive>;
extern template class TypedVertexPool<Segment2>;
extern template class TypedVertexPool<Line2>;
extern template class TypedEdgePool<SegmentObservation2, SE2, Segment2>;
extern template class TypedEdgePool<SegmentLineObservation2, SE2, Segment2>;
extern template class TypedEdgePool<SegmentEndObservation2, SE2, Segment2>;
extern template class TypedEdgePool<LineObservation2, SE2, Line2>;
extern template class TypedEdgePool<LineDifference2, Line2, Line2>;
extern template class TypedEdgePool<PointToLine2, Line2, Vector2>;

}  // namespace boxplus::detail
