// SPDX-License-Identifier: BSD-3-Clause
// The pools of the common models of bundle adjustment, which are compiled once, in the library.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/types/ba/camera_between.h"
#include "boxplus/types/ba/depth_image.h"
#include "boxplus/types/ba/image.h"
#include "boxplus/types/ba/inverse_depth.h"
#include "boxplus/types/ba/reprojection.h"
#include "boxplus/types/ba/similarity.h"
#include "boxplus/types/ba/twist_between.h"
#include "boxplus/types/range.h"
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
extern template class TypedVertexPool<SE3RotationVector>;
extern template class TypedVertexPool<StereoPose>;
extern template class TypedVertexPool<StereoCamera>;
extern template class TypedVertexPool<StereoIntrinsics>;
extern template class TypedEdgePool<TwistBetween, SE3RotationVector, SE3RotationVector>;
extern template class TypedEdgePool<PointImage<2>, Vector3, SE3RotationVector, StereoCamera>;
extern template class TypedEdgePool<PointImage<3>, Vector3, SE3RotationVector, StereoCamera>;
extern template class TypedEdgePool<CalibratedPointImage<2>, Vector3, SE3RotationVector>;
extern template class TypedEdgePool<CalibratedPointImage<3>, Vector3, SE3RotationVector>;
extern template class TypedEdgePool<KnownPointImage<2>, SE3RotationVector>;
extern template class TypedEdgePool<KnownPointImage<3>, SE3RotationVector>;
extern template class TypedVertexPool<SimilarityCamera>;
extern template class TypedEdgePool<InverseDepthImage, Vector3, SE3RotationVector, SE3RotationVector,
                                    StereoCamera>;
extern template class TypedEdgePool<PointImage<2>, Vector3, StereoPose>;
extern template class TypedEdgePool<PointImage<3>, Vector3, StereoPose>;
extern template class TypedEdgePool<PointImage<2>, Vector3, StereoPose, StereoIntrinsics>;
extern template class TypedEdgePool<CameraBetween, StereoPose, StereoPose>;
extern template class TypedEdgePool<Range, StereoPose, StereoPose>;
extern template class TypedEdgePool<SimilarityBetween, SimilarityCamera, SimilarityCamera>;
extern template class TypedEdgePool<SimilarityImage, Vector3, SimilarityCamera>;
extern template class TypedEdgePool<InverseSimilarityImage, Vector3, SimilarityCamera>;
extern template class TypedVertexPool<Product<SE3, PinholeCamera>>;
extern template class TypedEdgePool<DepthImage, SE3, Vector3, Product<SE3, PinholeCamera>>;
extern template class TypedEdgePool<DisparityImage, SE3, Vector3, Product<SE3, PinholeCamera>>;

}  // namespace boxplus::detail
