// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial.h"

namespace boxplus::detail {

template class TypedVertexPool<ImuBias>;
template class TypedEdgePool<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias>;
template class TypedEdgePool<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias, S2>;
template class TypedVertexPool<S2>;
template class TypedEdgePool<DirectionObservation, SE3, S2>;
template class TypedEdgePool<DirectionObservation, SE3, S2, SE3>;
template class TypedEdgePool<FieldObservation, SE3, Vector3, Vector3>;
template class TypedEdgePool<OffsetPositionPrior<Vector3>, SE3, Vector3>;

}  // namespace boxplus::detail
