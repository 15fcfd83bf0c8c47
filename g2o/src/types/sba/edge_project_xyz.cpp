// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a single camera. The point is either a vertex or known.
#include "g2o/types/sba/edge_project_xyz.h"

#include "core/edge_kind.h"
#include "g2o/types/sba/edge_project_xyz_onlypose.h"
#include "types/cameras.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

template <class Edge>
adapters::Pinhole camera_of(const Edge& edge) {
  return adapters::pinhole(edge.fx, edge.fy, edge.cx, edge.cy);
}

}  // namespace

EdgeSE3ProjectXYZ::EdgeSE3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeSE3ProjectXYZ::computeError() {
  _error = _measurement - camera_of(*this).image<2>(
                              adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate()));
}

void EdgeSE3ProjectXYZ::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = adapters::transformed(T, vertexXn<0>()->estimate());
  const adapters::ImageDerivatives<2> by(camera_of(*this), p);
  adapters::negative_by_point(by, T.rotation(), _jacobianOplusXi);
  adapters::negative_by_step(by, _jacobianOplusXj);
}

bool EdgeSE3ProjectXYZ::isDepthPositive() {
  return vertexXn<1>()->estimate().map(vertexXn<0>()->estimate())[2] > 0;
}

Vector2 EdgeSE3ProjectXYZ::cam_project(const Vector3& trans_xyz) const {
  return camera_of(*this).image<2>(trans_xyz);
}

bool EdgeSE3ProjectXYZ::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector2>(is, 2, _information,
                                                      [this](const auto& z) { setMeasurement(z); }) &&
         adapters::read_rest(is, {&fx, &fy, &cx, &cy});
}

bool EdgeSE3ProjectXYZ::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector2(_measurement), _information) &&
         adapters::write_rest(os, {fx, fy, cx, cy});
}

EdgeSE3ProjectXYZOnlyPose::EdgeSE3ProjectXYZOnlyPose() {
  _measurement.setZero();
}

void EdgeSE3ProjectXYZOnlyPose::computeError() {
  _error = _measurement - camera_of(*this).image<2>(adapters::transformed(vertexXn<0>()->estimate(), Xw));
}

void EdgeSE3ProjectXYZOnlyPose::linearizeOplus() {
  const Vector3 p = adapters::transformed(vertexXn<0>()->estimate(), Xw);
  adapters::negative_by_step(adapters::ImageDerivatives<2>(camera_of(*this), p), _jacobianOplusXi);
}

bool EdgeSE3ProjectXYZOnlyPose::isDepthPositive() {
  return vertexXn<0>()->estimate().map(Xw)[2] > 0;
}

Vector2 EdgeSE3ProjectXYZOnlyPose::cam_project(const Vector3& trans_xyz) const {
  return camera_of(*this).image<2>(trans_xyz);
}

bool EdgeSE3ProjectXYZOnlyPose::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector2>(is, 2, _information,
                                                      [this](const auto& z) { setMeasurement(z); }) &&
         adapters::read_rest(is, {&Xw[0], &Xw[1], &Xw[2], &fx, &fy, &cx, &cy});
}

bool EdgeSE3ProjectXYZOnlyPose::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector2(_measurement), _information) &&
         adapters::write_rest(os, {Xw[0], Xw[1], Xw[2], fx, fy, cx, cy});
}

namespace {

const internal::EvaluatedInRuns<EdgeSE3ProjectXYZ> kRunsOfSE3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeSE3ProjectXYZOnlyPose> kRunsOfSE3ProjectXYZOnlyPose;

}  // namespace

}  // namespace g2o
