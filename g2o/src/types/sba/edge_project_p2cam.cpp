// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in an SBACam, as a single camera or as a stereo pair.
#include "g2o/types/sba/edge_project_p2mc.h"
#include "g2o/types/sba/edge_project_p2sc.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

Vector3 in_camera(const SBACam& cam, const Vector3& point) {
  return cam.w2n * point.homogeneous();
}

double baseline_times_focal_length(const SBACam& cam) {
  return cam.Kcam(0, 0) * cam.baseline;
}

/// Computes the Jacobians of the image. The engine's tangent of a pose has the translation in the frame of
/// the camera, and g2o's in the world frame.
template <int Rows, class JPoint, class JCam>
void linearize(const SBACam& cam, const Vector3& point, JPoint& J_point, JCam& J_cam) {
  const Vector3 p = in_camera(cam, point);
  const auto D = adapters::image_by_point<Rows>(cam.Kcam, baseline_times_focal_length(cam), p);
  Eigen::Matrix<double, 3, 6> p_by_cam;
  Matrix3 p_by_point;
  boxplus::PointObservation3(p).jacobians(adapters::pose(cam), boxplus::Vector3(point), p_by_cam, p_by_point);
  J_point = D * p_by_point;
  J_cam = D * p_by_cam;
  J_cam.template leftCols<3>() *= cam.w2n.leftCols<3>();
}

}  // namespace

EdgeProjectP2MC::EdgeProjectP2MC() {
  _measurement.setZero();
}

void EdgeProjectP2MC::computeError() {
  const SBACam& cam = vertexXn<1>()->estimate();
  _error = adapters::image<2>(cam.Kcam, 0, in_camera(cam, vertexXn<0>()->estimate())) - _measurement;
}

void EdgeProjectP2MC::linearizeOplus() {
  linearize<2>(vertexXn<1>()->estimate(), vertexXn<0>()->estimate(), _jacobianOplusXi, _jacobianOplusXj);
}

bool EdgeProjectP2MC::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector2>(is, 2, _information,
                                                      [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectP2MC::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

EdgeProjectP2SC::EdgeProjectP2SC() {
  _measurement.setZero();
}

void EdgeProjectP2SC::computeError() {
  const SBACam& cam = vertexXn<1>()->estimate();
  _error = adapters::image<3>(cam.Kcam, baseline_times_focal_length(cam),
                              in_camera(cam, vertexXn<0>()->estimate())) -
           _measurement;
}

void EdgeProjectP2SC::linearizeOplus() {
  linearize<3>(vertexXn<1>()->estimate(), vertexXn<0>()->estimate(), _jacobianOplusXi, _jacobianOplusXj);
}

bool EdgeProjectP2SC::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector3>(is, 3, _information,
                                                      [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectP2SC::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector3(_measurement), _information);
}

}  // namespace g2o
