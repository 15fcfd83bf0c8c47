// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a camera whose intrinsics are a parameter of the graph.
#include "g2o/types/sba/edge_project_psi2uv.h"
#include "g2o/types/sba/edge_project_xyz2uv.h"
#include "g2o/types/sba/edge_project_xyz2uvu.h"
#include "types/exponential.h"
#include "types/images.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

formulas::Pinhole pinhole(const CameraParameters& cam) {
  return {cam.focal_length, cam.focal_length, cam.principle_point[0], cam.principle_point[1]};
}

/// Converts a point to ψ = (x/depth, y/depth, 1/depth). The function is its own inverse.
Vector3 invert_depth(const Vector3& x) {
  return x.head<2>().homogeneous() / x[2];
}

}  // namespace

EdgeProjectXYZ2UV::EdgeProjectXYZ2UV() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(_cam, 0);
}

void EdgeProjectXYZ2UV::computeError() {
  _error = _measurement - _cam->cam_map(vertexXn<1>()->estimate().map(vertexXn<0>()->estimate()));
}

void EdgeProjectXYZ2UV::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = T.map(vertexXn<0>()->estimate());
  const formulas::Pinhole camera = pinhole(*_cam);
  _jacobianOplusXi.noalias() = formulas::image_jacobian(camera, p) * -T.rotation().toRotationMatrix();
  _jacobianOplusXj = -formulas::image_by_motion(camera, p);
}

bool EdgeProjectXYZ2UV::read(std::istream& is) {
  return readParamIds(is) && adapters::read_measurement<boxplus::Vector2>(
                                 is, 2, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectXYZ2UV::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

EdgeProjectXYZ2UVU::EdgeProjectXYZ2UVU() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(_cam, 0);
}

void EdgeProjectXYZ2UVU::computeError() {
  _error = _measurement - _cam->stereocam_uvu_map(vertexXn<1>()->estimate().map(vertexXn<0>()->estimate()));
}

void EdgeProjectXYZ2UVU::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = T.map(vertexXn<0>()->estimate());
  const formulas::Pinhole camera = pinhole(*_cam);
  const double bf = _cam->focal_length * _cam->baseline;
  _jacobianOplusXi.noalias() =
      formulas::stereo_image_jacobian(camera, bf, p) * -T.rotation().toRotationMatrix();
  _jacobianOplusXj = -formulas::stereo_image_by_motion(camera, bf, p);
}

bool EdgeProjectXYZ2UVU::read(std::istream& is) {
  return readParamIds(is) && adapters::read_measurement<boxplus::Vector3>(
                                 is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectXYZ2UVU::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_measurement(os, boxplus::Vector3(_measurement), _information);
}

EdgeProjectPSI2UV::EdgeProjectPSI2UV() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(_cam, 0);
}

void EdgeProjectPSI2UV::computeError() {
  const SE3Quat motion = vertexXn<1>()->estimate() * vertexXn<2>()->estimate().inverse();
  _error = _measurement - _cam->cam_map(motion.map(invert_depth(vertexXn<0>()->estimate())));
}

// Let q be the point of ψ in the frame of the anchor. In the frame of the camera, the point is p = A q with A
// = T T_anchor⁻¹. A step δ of the anchor changes p to A exp(−δ) q.
void EdgeProjectPSI2UV::linearizeOplus() {
  const Vector3& psi = vertexXn<0>()->estimate();
  const SE3Quat motion = vertexXn<1>()->estimate() * vertexXn<2>()->estimate().inverse();
  const Vector3 q = invert_depth(psi), p = motion.map(q);
  const formulas::Pinhole camera = pinhole(*_cam);
  const Eigen::Matrix<double, 2, 3> D = formulas::image_jacobian(camera, p);
  const Eigen::Matrix<double, 2, 3> DR = D * motion.rotation().toRotationMatrix();
  Matrix3 dq_dpsi = Matrix3::Identity() / psi[2];
  dq_dpsi.col(2) = -q / psi[2];
  std::get<0>(_jacobianOplus) = -DR * dq_dpsi;
  std::get<1>(_jacobianOplus) = -formulas::image_by_motion(camera, p);
  std::get<2>(_jacobianOplus) = DR * formulas::motion_of_point(q);
}

bool EdgeProjectPSI2UV::read(std::istream& is) {
  return readParamIds(is) && adapters::read_measurement<boxplus::Vector2>(
                                 is, 2, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectPSI2UV::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

}  // namespace g2o
