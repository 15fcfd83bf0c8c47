// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/sba/vertex_sba_pointxyz.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "types/sba/adapters_sba.h"

namespace g2o {

VertexSBAPointXYZ::VertexSBAPointXYZ() = default;

VertexSE3Expmap::VertexSE3Expmap() = default;

void VertexSE3Expmap::oplusImpl(double* update) {
  _estimate = SE3Quat::exp(Eigen::Map<const Vector6>(update)) * _estimate;
}

bool VertexSE3Expmap::read(std::istream& is) {
  boxplus::SE3 x;
  if (!adapters::read_value(is, 7, x)) return false;
  setEstimate(adapters::to_se3quat(x).inverse());
  return true;
}

bool VertexSE3Expmap::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::pose(_estimate.inverse()));
}

bool VertexSE3Expmap::getEstimateData(double* est) const {
  const Vector7 v = _estimate.toVector();
  std::copy_n(v.data(), 7, est);
  return true;
}

bool VertexSE3Expmap::getMinimalEstimateData(double* est) const {
  const Vector6 v = _estimate.toMinimalVector();
  std::copy_n(v.data(), 6, est);
  return true;
}

bool VertexSE3Expmap::setEstimateDataImpl(const double* est) {
  _estimate.fromVector(Eigen::Map<const Vector7>(est));
  return true;
}

bool VertexSE3Expmap::setMinimalEstimateDataImpl(const double* est) {
  _estimate.fromMinimalVector(Eigen::Map<const Vector6>(est));
  return true;
}

CameraParameters::CameraParameters() = default;

CameraParameters::CameraParameters(double focalLength, const Vector2& principlePoint, double baseLine)
    : focal_length(focalLength), principle_point(principlePoint), baseline(baseLine) {}

Vector2 CameraParameters::cam_map(const Vector3& trans_xyz) const {
  return adapters::camera(*this).pinhole().image<2>(trans_xyz);
}

Vector3 CameraParameters::stereocam_uvu_map(const Vector3& trans_xyz) const {
  return adapters::camera(*this).pinhole().image<3>(trans_xyz);
}

bool CameraParameters::read(std::istream& is) {
  boxplus::Vector<double, 4> v;
  if (!adapters::read_value(is, 4, v)) return false;
  focal_length = v[0];
  principle_point = v.segment<2>(1);
  baseline = v[3];
  return true;
}

bool CameraParameters::write(std::ostream& os) const {
  return adapters::write_value(
      os, boxplus::Vector<double, 4>(focal_length, principle_point[0], principle_point[1], baseline));
}

}  // namespace g2o
