// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a stereo camera. The point is either a vertex or known.
#include "g2o/types/sba/edge_project_stereo_xyz.h"

#include "core/edge_kind.h"
#include "g2o/types/sba/edge_project_stereo_xyz_onlypose.h"
#include "types/cameras.h"
#include "types/sba/adapters_sba.h"

namespace g2o {

EdgeStereoSE3ProjectXYZ::EdgeStereoSE3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeStereoSE3ProjectXYZ::computeError() {
  _error = _measurement -
           cam_project(adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate()), bf);
}

void EdgeStereoSE3ProjectXYZ::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = adapters::transformed(T, vertexXn<0>()->estimate());
  const adapters::ImageDerivatives<3> by(adapters::pinhole(fx, fy, cx, cy, bf), p);
  adapters::negative_by_point(by, T.rotation(), _jacobianOplusXi);
  adapters::negative_by_step(by, _jacobianOplusXj);
}

bool EdgeStereoSE3ProjectXYZ::isDepthPositive() {
  return adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate())[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZ::cam_project(const Vector3& trans_xyz, const double& baseline_fx) const {
  return adapters::pinhole(fx, fy, cx, cy, baseline_fx).image<3>(trans_xyz);
}

bool EdgeStereoSE3ProjectXYZ::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector3>(is, 3, _information,
                                                      [this](const auto& z) { setMeasurement(z); }) &&
         adapters::read_rest(is, {&fx, &fy, &cx, &cy, &bf});
}

bool EdgeStereoSE3ProjectXYZ::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector3(_measurement), _information) &&
         adapters::write_rest(os, {fx, fy, cx, cy, bf});
}

EdgeStereoSE3ProjectXYZOnlyPose::EdgeStereoSE3ProjectXYZOnlyPose() {
  _measurement.setZero();
}

void EdgeStereoSE3ProjectXYZOnlyPose::computeError() {
  _error = _measurement - cam_project(adapters::transformed(vertexXn<0>()->estimate(), Xw));
}

void EdgeStereoSE3ProjectXYZOnlyPose::linearizeOplus() {
  const Vector3 p = adapters::transformed(vertexXn<0>()->estimate(), Xw);
  adapters::negative_by_step(adapters::ImageDerivatives<3>(adapters::pinhole(fx, fy, cx, cy, bf), p),
                             _jacobianOplusXi);
}

bool EdgeStereoSE3ProjectXYZOnlyPose::isDepthPositive() {
  return adapters::transformed(vertexXn<0>()->estimate(), Xw)[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZOnlyPose::cam_project(const Vector3& trans_xyz) const {
  return adapters::pinhole(fx, fy, cx, cy, bf).image<3>(trans_xyz);
}

bool EdgeStereoSE3ProjectXYZOnlyPose::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector3>(is, 3, _information,
                                                      [this](const auto& z) { setMeasurement(z); }) &&
         adapters::read_rest(is, {&Xw[0], &Xw[1], &Xw[2], &fx, &fy, &cx, &cy, &bf});
}

bool EdgeStereoSE3ProjectXYZOnlyPose::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector3(_measurement), _information) &&
         adapters::write_rest(os, {Xw[0], Xw[1], Xw[2], fx, fy, cx, cy, bf});
}

namespace {

const internal::EvaluatedInRuns<EdgeStereoSE3ProjectXYZ> kRunsOfStereoSE3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeStereoSE3ProjectXYZOnlyPose> kRunsOfStereoSE3ProjectXYZOnlyPose;

}  // namespace

}  // namespace g2o
