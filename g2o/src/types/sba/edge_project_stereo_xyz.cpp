// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a stereo camera. The point is either a vertex or known.
#include "g2o/types/sba/edge_project_stereo_xyz.h"

#include "core/edge_kind.h"
#include "g2o/types/sba/edge_project_stereo_xyz_onlypose.h"
#include "types/images.h"
#include "types/sba/adapters_sba.h"

namespace g2o {

EdgeStereoSE3ProjectXYZ::EdgeStereoSE3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeStereoSE3ProjectXYZ::computeError() {
  _error = _measurement - cam_project(vertexXn<1>()->estimate().map(vertexXn<0>()->estimate()), bf);
}

void EdgeStereoSE3ProjectXYZ::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = T.map(vertexXn<0>()->estimate());
  const formulas::Pinhole camera{fx, fy, cx, cy};
  _jacobianOplusXi.noalias() =
      formulas::stereo_image_jacobian(camera, bf, p) * -T.rotation().toRotationMatrix();
  _jacobianOplusXj = -formulas::stereo_image_by_motion(camera, bf, p);
}

bool EdgeStereoSE3ProjectXYZ::isDepthPositive() {
  return vertexXn<1>()->estimate().map(vertexXn<0>()->estimate())[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZ::cam_project(const Vector3& trans_xyz, const double& baseline_fx) const {
  return formulas::stereo_image(formulas::Pinhole{fx, fy, cx, cy}, baseline_fx, trans_xyz);
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
  _error = _measurement - cam_project(vertexXn<0>()->estimate().map(Xw));
}

void EdgeStereoSE3ProjectXYZOnlyPose::linearizeOplus() {
  const Vector3 p = vertexXn<0>()->estimate().map(Xw);
  _jacobianOplusXi = -formulas::stereo_image_by_motion({fx, fy, cx, cy}, bf, p);
}

bool EdgeStereoSE3ProjectXYZOnlyPose::isDepthPositive() {
  return vertexXn<0>()->estimate().map(Xw)[2] > 0;
}

Vector3 EdgeStereoSE3ProjectXYZOnlyPose::cam_project(const Vector3& trans_xyz) const {
  return formulas::stereo_image(formulas::Pinhole{fx, fy, cx, cy}, bf, trans_xyz);
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
