// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d.h"

namespace boxplus::detail {

template class TypedVertexPool<SE3>;
template class TypedVertexPool<Vector3>;
template class TypedEdgePool<Between<SE3>, SE3, SE3>;
template class TypedEdgePool<Between<Vector3>, Vector3, Vector3>;
template class TypedEdgePool<Prior<SE3>, SE3>;
template class TypedEdgePool<Prior<Vector3>, Vector3>;
template class TypedEdgePool<PositionPrior<Vector3>, SE3>;
template class TypedEdgePool<PositionPrior<Vector3>, SE3, SE3>;
template class TypedEdgePool<OffsetPrior<SE3>, SE3, SE3>;
template class TypedEdgePool<OffsetBetween<SE3>, SE3, SE3, SE3>;
template class TypedEdgePool<OffsetBetween<SE3>, SE3, SE3, SE3, SE3>;
template class TypedEdgePool<PointObservation3, SE3, Vector3>;
template class TypedEdgePool<OffsetPointObservation3, SE3, Vector3, SE3>;
template class TypedEdgePool<PointsObservation3, SE3, Tail<Vector3>>;
template class TypedEdgePool<BearingObservation3, SE3, Vector3>;
template class TypedEdgePool<Range, SE3, Vector3>;
template class TypedVertexPool<Plane3>;
template class TypedVertexPool<Line3>;
template class TypedEdgePool<PlaneObservation3, SE3, Plane3>;
template class TypedEdgePool<PlaneObservation3, SE3, Plane3, SE3>;
template class TypedEdgePool<PlaneDifference3, Plane3, Plane3>;
template class TypedEdgePool<LineObservation3, SE3, Line3>;
template class TypedEdgePool<LineObservation3, SE3, Line3, SE3>;
template class TypedEdgePool<SurfaceMatch, SE3, SE3>;

}  // namespace boxplus::detail
