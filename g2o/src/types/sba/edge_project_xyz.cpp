// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a single camera. The point is either a vertex or known.
#include "g2o/types/sba/edge_project_xyz.h"

#include "core/edge_kind.h"
#include "g2o/types/sba/edge_project_xyz_onlypose.h"
#include "types/sba/image_model.h"

namespace g2o {
namespace {

template <class Edge>
adapters::Pinhole camera_of(const Edge& edge) {
  return adapters::pinhole(edge.fx, edge.fy, edge.cx, edge.cy);
}

}  // namespace

bool EdgeSE3ProjectXYZ::isDepthPositive() {
  return vertexXn<1>()->estimate().map(vertexXn<0>()->estimate())[2] > 0;
}

Vector2 EdgeSE3ProjectXYZ::cam_project(const Vector3& trans_xyz) const {
  return camera_of(*this).image<2>(trans_xyz);
}

bool EdgeSE3ProjectXYZOnlyPose::isDepthPositive() {
  return vertexXn<0>()->estimate().map(Xw)[2] > 0;
}

Vector2 EdgeSE3ProjectXYZOnlyPose::cam_project(const Vector3& trans_xyz) const {
  return camera_of(*this).image<2>(trans_xyz);
}

namespace internal {

template <class Edge>
struct SingleCameraModel : ImageModel<Edge> {
  static adapters::Pinhole camera(const Edge& e) { return camera_of(e); }
};

template <>
struct EdgeModel<EdgeSE3ProjectXYZ> : SingleCameraModel<EdgeSE3ProjectXYZ> {
  template <class Edge>
  static auto rest(Edge& e) {
    return std::array{&e.fx, &e.fy, &e.cx, &e.cy};
  }
};
template <>
struct EdgeModel<EdgeSE3ProjectXYZOnlyPose> : SingleCameraModel<EdgeSE3ProjectXYZOnlyPose> {
  template <class Edge>
  static auto rest(Edge& e) {
    return std::array{&e.Xw[0], &e.Xw[1], &e.Xw[2], &e.fx, &e.fy, &e.cx, &e.cy};
  }
};

template struct EdgeFunctions<EdgeSE3ProjectXYZ>;
template struct EdgeFunctions<EdgeSE3ProjectXYZOnlyPose>;

}  // namespace internal

EdgeSE3ProjectXYZ::EdgeSE3ProjectXYZ() = default;
EdgeSE3ProjectXYZOnlyPose::EdgeSE3ProjectXYZOnlyPose() = default;

namespace {

const internal::EvaluatedInRuns<EdgeSE3ProjectXYZ> kRunsOfSE3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeSE3ProjectXYZOnlyPose> kRunsOfSE3ProjectXYZOnlyPose;

}  // namespace

}  // namespace g2o
