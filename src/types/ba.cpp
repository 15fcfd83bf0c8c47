// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba.h"

namespace boxplus::detail {

template class TypedVertexPool<Product<SE3, BalCamera>>;
template class TypedVertexPool<BalCamera>;
template class TypedVertexPool<PinholeCamera>;
template class TypedVertexPool<SimpleRadialCamera>;
template class TypedVertexPool<RadialCamera>;
template class TypedVertexPool<OpenCvCamera>;
template class TypedVertexPool<OpenCvFisheyeCamera>;
template class TypedEdgePool<Reprojection<BalCamera>, Product<SE3, BalCamera>, Vector3>;
template class TypedEdgePool<Reprojection<BalCamera>, SE3, Vector3, BalCamera>;
template class TypedEdgePool<Reprojection<PinholeCamera>, SE3, Vector3, PinholeCamera>;
template class TypedEdgePool<Reprojection<SimpleRadialCamera>, SE3, Vector3, SimpleRadialCamera>;
template class TypedEdgePool<Reprojection<RadialCamera>, SE3, Vector3, RadialCamera>;
template class TypedEdgePool<Reprojection<OpenCvCamera>, SE3, Vector3, OpenCvCamera>;
template class TypedEdgePool<Reprojection<OpenCvFisheyeCamera>, SE3, Vector3, OpenCvFisheyeCamera>;

}  // namespace boxplus::detail
