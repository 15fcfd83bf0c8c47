// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a camera whose intrinsics are a parameter of the graph.
#include "boxplus/types/ba/inverse_depth.h"
#include "g2o/types/sba/edge_project_psi2uv.h"
#include "g2o/types/sba/edge_project_xyz2uv.h"
#include "g2o/types/sba/edge_project_xyz2uvu.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

using Native = boxplus::InverseDepthImage;

/// The pose of a camera, given the motion from the world to the camera.
boxplus::SE3RotationVector pose_of(const VertexSE3Expmap& camera) {
  const boxplus::SE3 pose = adapters::pose(camera.estimate().inverse());
  return boxplus::SE3RotationVector::from_unit(pose.translation(), pose.quaternion());
}

}  // namespace

EdgeProjectXYZ2UV::EdgeProjectXYZ2UV() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(_cam, 0);
}

void EdgeProjectXYZ2UV::computeError() {
  _error = _measurement -
           _cam->cam_map(adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate()));
}

void EdgeProjectXYZ2UV::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = adapters::transformed(T, vertexXn<0>()->estimate());
  const adapters::ImageDerivatives<2> by(adapters::camera(*_cam).pinhole(), p);
  adapters::negative_by_point(by, T.rotation(), _jacobianOplusXi);
  adapters::negative_by_step(by, _jacobianOplusXj);
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
  _error = _measurement - _cam->stereocam_uvu_map(
                              adapters::transformed(vertexXn<1>()->estimate(), vertexXn<0>()->estimate()));
}

void EdgeProjectXYZ2UVU::linearizeOplus() {
  const SE3Quat& T = vertexXn<1>()->estimate();
  const Vector3 p = adapters::transformed(T, vertexXn<0>()->estimate());
  const adapters::ImageDerivatives<3> by(adapters::camera(*_cam).pinhole(), p);
  adapters::negative_by_point(by, T.rotation(), _jacobianOplusXi);
  adapters::negative_by_step(by, _jacobianOplusXj);
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
  _error = -Native(_measurement)
                .error(adapters::point(*vertexXn<0>()), pose_of(*vertexXn<1>()), pose_of(*vertexXn<2>()),
                       adapters::camera(*_cam));
}

// The error is the negative of the engine's, and a step T ← exp(ω, υ) T changes the pose X = T⁻¹ of the
// engine to X exp(−ω, −υ). The signs cancel.
void EdgeProjectPSI2UV::linearizeOplus() {
  Eigen::Matrix<double, 2, 3> by_point;
  Eigen::Matrix<double, 2, 6> by_pose, by_anchor;
  adapters::linearize(
      Native(_measurement),
      adapters::Argument<boxplus::Vector3>{adapters::point(*vertexXn<0>()), by_point.data()},
      adapters::Argument<boxplus::SE3RotationVector>{pose_of(*vertexXn<1>()), by_pose.data()},
      adapters::Argument<boxplus::SE3RotationVector>{pose_of(*vertexXn<2>()), by_anchor.data()},
      adapters::Argument<boxplus::StereoCamera>{adapters::camera(*_cam), nullptr});
  std::get<0>(_jacobianOplus) = -by_point;
  std::get<1>(_jacobianOplus) << by_pose.rightCols<3>(), by_pose.leftCols<3>();
  std::get<2>(_jacobianOplus) << by_anchor.rightCols<3>(), by_anchor.leftCols<3>();
}

bool EdgeProjectPSI2UV::read(std::istream& is) {
  return readParamIds(is) && adapters::read_measurement<boxplus::Vector2>(
                                 is, 2, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectPSI2UV::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

}  // namespace g2o
