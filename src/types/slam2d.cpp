// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d.h"

namespace boxplus::detail {

template class TypedVertexPool<SE2>;
template class TypedVertexPool<Vector2>;
template class TypedVertexPool<DifferentialDrive>;
template class TypedEdgePool<Between<SE2>, SE2, SE2>;
template class TypedEdgePool<Between<Vector2>, Vector2, Vector2>;
template class TypedEdgePool<Prior<SE2>, SE2>;
template class TypedEdgePool<Prior<Vector2>, Vector2>;
template class TypedEdgePool<PositionPrior<Vector2>, SE2>;
template class TypedEdgePool<OffsetBetween<SE2>, SE2, SE2, SE2>;
template class TypedEdgePool<OffsetBetween<SE2>, SE2, SE2, SE2, SE2>;
template class TypedEdgePool<PointObservation2, SE2, Vector2>;
template class TypedEdgePool<OffsetPointObservation2, SE2, Vector2, SE2>;
template class TypedEdgePool<TwoPointsObservation2, SE2, Vector2, Vector2>;
template class TypedEdgePool<PointsObservation2, SE2, Tail<Vector2>>;
template class TypedEdgePool<BearingObservation2, SE2, Vector2>;
template class TypedEdgePool<Range, SE2, Vector2>;
template class TypedEdgePool<WheelOdometry, SE2, SE2, DifferentialDrive>;
template class TypedVertexPool<Segment2>;
template class TypedVertexPool<Line2>;
template class TypedEdgePool<SegmentObservation2, SE2, Segment2>;
template class TypedEdgePool<SegmentLineObservation2, SE2, Segment2>;
template class TypedEdgePool<SegmentEndObservation2, SE2, Segment2>;
template class TypedEdgePool<LineObservation2, SE2, Line2>;
template class TypedEdgePool<LineDifference2, Line2, Line2>;
template class TypedEdgePool<PointToLine2, Line2, Vector2>;

}  // namespace boxplus::detail
