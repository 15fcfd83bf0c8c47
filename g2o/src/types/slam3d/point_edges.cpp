// SPDX-License-Identifier: BSD-3-Clause
// Edges of points in space.
#include <tuple>

#include "g2o/core/thread_safe.h"
#include "g2o/types/slam3d/edge_pointxyz.h"
#include "g2o/types/slam3d/edge_se3_pointxyz.h"
#include "g2o/types/slam3d/edge_se3_pointxyz_depth.h"
#include "g2o/types/slam3d/edge_se3_pointxyz_disparity.h"
#include "g2o/types/slam3d/edge_xyz_prior.h"
#include "types/ready_made_edge.h"
#include "types/slam3d/depth_image.h"

namespace g2o {
namespace internal {

template <>
struct EdgeModel<EdgePointXYZ> {
  using Native = boxplus::Between<boxplus::Vector3>;
  static Vector3 measured(const EdgePointXYZ& e) { return estimate<1>(e) - estimate<0>(e); }
  static Vector3 first(const EdgePointXYZ& e) { return estimate<1>(e) - e.measurement(); }
  static Vector3 second(const EdgePointXYZ& e) { return estimate<0>(e) + e.measurement(); }
};

template <>
struct EdgeModel<EdgeXYZPrior> {
  using Native = boxplus::Prior<boxplus::Vector3>;
  static Vector3 measured(const EdgeXYZPrior& e) { return estimate<0>(e); }
  static Vector3 first(const EdgeXYZPrior& e) { return e.measurement(); }
};

template <>
struct EdgeModel<EdgeSE3PointXYZ> {
  using Native = boxplus::OffsetPointObservation3;
  static auto parameters(const EdgeSE3PointXYZ& e) {
    return std::tuple(adapters::pose(*e.offsetParameter()));
  }
  static Vector3 measured(const EdgeSE3PointXYZ& e) {
    return (estimate<0>(e) * e.offsetParameter()->offset()).inverse() * estimate<1>(e);
  }
  static Vector3 second(const EdgeSE3PointXYZ& e) {
    return estimate<0>(e) * (e.offsetParameter()->offset() * e.measurement());
  }
};

/// The third coordinate of the image is the depth of the point, or the inverse of the depth.
template <class Edge, class Image, bool inverse>
struct DepthImageModel {
  static std::tuple<> parameters(const Edge&) { return {}; }
  static Vector3 error(const Edge& e, const Vector3& z) {
    return adapters::depth_image_error<Image>(z, *e.template vertexXn<0>(), *e.template vertexXn<1>(),
                                              *e.cameraParameter());
  }
  static Vector3 error(const Edge& e) { return error(e, e.measurement()); }
  static void linearize(Edge& e) {
    adapters::linearize_depth_image<Image>(*e.template vertexXn<0>(), *e.template vertexXn<1>(),
                                           *e.cameraParameter(), e.template jacobianOplusXn<0>(),
                                           e.template jacobianOplusXn<1>());
  }
  static Vector3 measured(const Edge& e) { return error(e, Vector3::Zero()); }
  static Vector3 second(const Edge& e) {
    const ParameterCamera& camera = *e.cameraParameter();
    const Vector3& z = e.measurement();
    const Vector3 p = (inverse ? 1 / z[2] : z[2]) * (camera.invKcam() * Vector3(z[0], z[1], 1));
    return estimate<0>(e) * (camera.offset() * p);
  }
};
template <>
struct EdgeModel<EdgeSE3PointXYZDepth> : DepthImageModel<EdgeSE3PointXYZDepth, boxplus::DepthImage, false> {};
template <>
struct EdgeModel<EdgeSE3PointXYZDisparity>
    : DepthImageModel<EdgeSE3PointXYZDisparity, boxplus::DisparityImage, true> {};

template struct EdgeFunctions<EdgePointXYZ>;
template struct EdgeFunctions<EdgeXYZPrior>;
template struct EdgeFunctions<EdgeSE3PointXYZ>;
template struct EdgeFunctions<EdgeSE3PointXYZDepth>;
template struct EdgeFunctions<EdgeSE3PointXYZDisparity>;

}  // namespace internal

EdgePointXYZ::EdgePointXYZ() = default;
EdgeXYZPrior::EdgeXYZPrior() = default;

EdgeSE3PointXYZ::EdgeSE3PointXYZ() {
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

EdgeSE3PointXYZDepth::EdgeSE3PointXYZDepth() {
  resizeParameters(1);
  installParameter(params, 0);
}

EdgeSE3PointXYZDisparity::EdgeSE3PointXYZDisparity() {
  resizeParameters(1);
  installParameter(params, 0);
}

namespace {

const ThreadSafe<EdgePointXYZ> kThreadSafePointXYZ;
const ThreadSafe<EdgeXYZPrior> kThreadSafeXYZPrior;

}  // namespace
}  // namespace g2o
