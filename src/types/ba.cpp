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
template class TypedVertexPool<SE3RotationVector>;
template class TypedVertexPool<StereoPose>;
template class TypedVertexPool<StereoCamera>;
template class TypedVertexPool<StereoIntrinsics>;
template class TypedEdgePool<TwistBetween, SE3RotationVector, SE3RotationVector>;
template class TypedEdgePool<PointImage<2>, Vector3, SE3RotationVector, StereoCamera>;
template class TypedEdgePool<PointImage<3>, Vector3, SE3RotationVector, StereoCamera>;
template class TypedEdgePool<CalibratedPointImage<2>, Vector3, SE3RotationVector>;
template class TypedEdgePool<CalibratedPointImage<3>, Vector3, SE3RotationVector>;
template class TypedEdgePool<KnownPointImage<2>, SE3RotationVector>;
template class TypedEdgePool<KnownPointImage<3>, SE3RotationVector>;
template class TypedVertexPool<SimilarityCamera>;
template class TypedEdgePool<InverseDepthImage, Vector3, SE3RotationVector, SE3RotationVector, StereoCamera>;
template class TypedEdgePool<PointImage<2>, Vector3, StereoPose>;
template class TypedEdgePool<PointImage<3>, Vector3, StereoPose>;
template class TypedEdgePool<PointImage<2>, Vector3, StereoPose, StereoIntrinsics>;
template class TypedEdgePool<CameraBetween, StereoPose, StereoPose>;
template class TypedEdgePool<Range, StereoPose, StereoPose>;
template class TypedEdgePool<SimilarityBetween, SimilarityCamera, SimilarityCamera>;
template class TypedEdgePool<SimilarityImage, Vector3, SimilarityCamera>;
template class TypedEdgePool<InverseSimilarityImage, Vector3, SimilarityCamera>;
template class TypedVertexPool<Product<SE3, PinholeCamera>>;
template class TypedEdgePool<DepthImage, SE3, Vector3, Product<SE3, PinholeCamera>>;
template class TypedEdgePool<DisparityImage, SE3, Vector3, Product<SE3, PinholeCamera>>;

}  // namespace boxplus::detail
