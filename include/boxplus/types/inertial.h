// SPDX-License-Identifier: BSD-3-Clause
// All ready-made types for inertial sensors. Their pools are compiled once, in the library.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/types/inertial/direction_observation.h"
#include "boxplus/types/inertial/inertial_between.h"
#include "boxplus/types/inertial/time_shifted.h"
#include "boxplus/types/offset_position_prior.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/vertex_pools.h"

namespace boxplus::detail {

extern template class TypedVertexPool<ImuBias>;
extern template class TypedEdgePool<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias>;
extern template class TypedEdgePool<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias, S2>;
extern template class TypedVertexPool<S2>;
extern template class TypedEdgePool<DirectionObservation, SE3, S2>;
extern template class TypedEdgePool<DirectionObservation, SE3, S2, SE3>;
extern template class TypedEdgePool<FieldObservation, SE3, Vector3, Vector3>;
extern template class TypedEdgePool<OffsetPositionPrior<Vector3>, SE3, Vector3>;

}  // namespace boxplus::detail
