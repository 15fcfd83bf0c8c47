// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a stereo camera. The point is either a vertex or known.
#include "g2o/types/sba/edge_project_stereo_xyz.h"

#include "core/edge_kind.h"
#include "g2o/types/sba/edge_project_stereo_xyz_onlypose.h"
#include "types/sba/image_model.h"

namespace g2o {

bool EdgeStereoSE3ProjectXYZ::isDepthPositive() {
  return adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate())[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZ::cam_project(const Vector3& trans_xyz, const double& baseline_fx) const {
  return adapters::pinhole(fx, fy, cx, cy, baseline_fx).image<3>(trans_xyz);
}

bool EdgeStereoSE3ProjectXYZOnlyPose::isDepthPositive() {
  return adapters::transformed(vertexXn<0>()->estimate(), Xw)[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZOnlyPose::cam_project(const Vector3& trans_xyz) const {
  return adapters::pinhole(fx, fy, cx, cy, bf).image<3>(trans_xyz);
}

namespace internal {

template <class Edge>
struct StereoCameraModel : ImageModel<Edge> {
  static adapters::Pinhole camera(const Edge& e) { return adapters::pinhole(e.fx, e.fy, e.cx, e.cy, e.bf); }
};

template <>
struct EdgeModel<EdgeStereoSE3ProjectXYZ> : StereoCameraModel<EdgeStereoSE3ProjectXYZ> {
  template <class Edge>
  static auto rest(Edge& e) {
    return std::array{&e.fx, &e.fy, &e.cx, &e.cy, &e.bf};
  }
};
template <>
struct EdgeModel<EdgeStereoSE3ProjectXYZOnlyPose> : StereoCameraModel<EdgeStereoSE3ProjectXYZOnlyPose> {
  template <class Edge>
  static auto rest(Edge& e) {
    return std::array{&e.Xw[0], &e.Xw[1], &e.Xw[2], &e.fx, &e.fy, &e.cx, &e.cy, &e.bf};
  }
};

template struct EdgeFunctions<EdgeStereoSE3ProjectXYZ>;
template struct EdgeFunctions<EdgeStereoSE3ProjectXYZOnlyPose>;

}  // namespace internal

EdgeStereoSE3ProjectXYZ::EdgeStereoSE3ProjectXYZ() = default;
EdgeStereoSE3ProjectXYZOnlyPose::EdgeStereoSE3ProjectXYZOnlyPose() = default;

namespace {

const internal::EvaluatedInRuns<EdgeStereoSE3ProjectXYZ> kRunsOfStereoSE3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeStereoSE3ProjectXYZOnlyPose> kRunsOfStereoSE3ProjectXYZOnlyPose;

}  // namespace

}  // namespace g2o
