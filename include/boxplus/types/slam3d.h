// SPDX-License-Identifier: BSD-3-Clause
// All ready-made types in space. Their pools are compiled once, in the library.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/types/between.h"
#include "boxplus/types/offset_between.h"
#include "boxplus/types/offset_prior.h"
#include "boxplus/types/position_prior.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/range.h"
#include "boxplus/types/slam3d/bearing_observation.h"
#include "boxplus/types/slam3d/line.h"
#include "boxplus/types/slam3d/plane.h"
#include "boxplus/types/slam3d/point_observation.h"
#include "boxplus/types/slam3d/points_observation.h"
#include "boxplus/types/slam3d/surface_match.h"

namespace boxplus::detail {

extern template class TypedEdgePool<PositionPrior<Vector3>, SE3>;
extern template class TypedEdgePool<PositionPrior<Vector3>, SE3, SE3>;
extern template class TypedEdgePool<OffsetPrior<SE3>, SE3, SE3>;
extern template class TypedEdgePool<OffsetBetween<SE3>, SE3, SE3, SE3>;
extern template class TypedEdgePool<OffsetBetween<SE3>, SE3, SE3, SE3, SE3>;
extern template class TypedEdgePool<PointObservation3, SE3, Vector3>;
extern template class TypedEdgePool<OffsetPointObservation3, SE3, Vector3, SE3>;
extern template class TypedEdgePool<PointsObservation3, SE3, Tail<Vector3>>;
extern template class TypedEdgePool<BearingObservation3, SE3, Vector3>;
extern template class TypedEdgePool<Range, SE3, Vector3>;
extern template class TypedVertexPool<Plane3>;
extern template class TypedVertexPool<Line3>;
extern template class TypedEdgePool<PlaneObservation3, SE3, Plane3>;
extern template class TypedEdgePool<PlaneObservation3, SE3, Plane3, SE3>;
extern template class TypedEdgePool<PlaneDifference3, Plane3, Plane3>;
extern template class TypedEdgePool<LineObservation3, SE3, Line3>;
extern template class TypedEdgePool<LineObservation3, SE3, Line3, SE3>;
extern template class TypedEdgePool<SurfaceMatch, SE3, SE3>;

}  // namespace boxplus::detail
