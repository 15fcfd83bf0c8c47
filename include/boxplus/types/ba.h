// SPDX-License-Identifier: BSD-3-Clause
// Cameras and reprojection errors, for bundle adjustment. The pools of the common models are compiled once,
// in the library.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/types/ba/reprojection.h"
#include "boxplus/types/vertex_pools.h"

namespace boxplus::detail {

extern template class TypedVertexPool<Product<SE3, BalCamera>>;
extern template class TypedVertexPool<BalCamera>;
extern template class TypedVertexPool<PinholeCamera>;
extern template class TypedVertexPool<SimpleRadialCamera>;
extern template class TypedVertexPool<RadialCamera>;
extern template class TypedVertexPool<OpenCvCamera>;
extern template class TypedVertexPool<OpenCvFisheyeCamera>;
extern template class TypedEdgePool<Reprojection<BalCamera>, Product<SE3, BalCamera>, Vector3>;
extern template class TypedEdgePool<Reprojection<BalCamera>, SE3, Vector3, BalCamera>;
extern template class TypedEdgePool<Reprojection<PinholeCamera>, SE3, Vector3, PinholeCamera>;
extern template class TypedEdgePool<Reprojection<SimpleRadialCamera>, SE3, Vector3, SimpleRadialCamera>;
extern template class TypedEdgePool<Reprojection<RadialCamera>, SE3, Vector3, RadialCamera>;
extern template class TypedEdgePool<Reprojection<OpenCvCamera>, SE3, Vector3, OpenCvCamera>;
extern template class TypedEdgePool<Reprojection<OpenCvFisheyeCamera>, SE3, Vector3, OpenCvFisheyeCamera>;

}  // namespace boxplus::detail
