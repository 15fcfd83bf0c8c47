// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in an SBACam, as a single camera or as a stereo pair.
#include "g2o/types/sba/edge_project_p2mc.h"
#include "g2o/types/sba/edge_project_p2sc.h"
#include "types/images.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

Vector3 in_camera(const SBACam& cam, const Vector3& point) {
  return cam.w2n * point.homogeneous();
}

double baseline_times_focal_length(const SBACam& cam) {
  return cam.Kcam(0, 0) * cam.baseline;
}

/// Computes the Jacobians from D, the derivative of an image with respect to the point in the frame of the
/// camera.
template <class Derivative, class JPoint, class JCam>
void linearize(const SBACam& cam, const Vector3& point, const Derivative& D, JPoint& J_point, JCam& J_cam) {
  const auto R = cam.w2n.leftCols<3>();
  const Vector3 arm = point - cam.translation();
  J_point = D * R;
  J_cam.template leftCols<3>() = -J_point;
  J_cam.col(3) = D * (cam.dRdx * arm);
  J_cam.col(4) = D * (cam.dRdy * arm);
  J_cam.col(5) = D * (cam.dRdz * arm);
}

}  // namespace

EdgeProjectP2MC::EdgeProjectP2MC() {
  _measurement.setZero();
}

void EdgeProjectP2MC::computeError() {
  const SBACam& cam = vertexXn<1>()->estimate();
  _error = formulas::image(cam.Kcam, in_camera(cam, vertexXn<0>()->estimate())) - _measurement;
}

void EdgeProjectP2MC::linearizeOplus() {
  const SBACam& cam = vertexXn<1>()->estimate();
  const Vector3& point = vertexXn<0>()->estimate();
  linearize(cam, point, formulas::image_jacobian(cam.Kcam, in_camera(cam, point)), _jacobianOplusXi,
            _jacobianOplusXj);
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
  _error = formulas::stereo_image(cam.Kcam, baseline_times_focal_length(cam),
                                  in_camera(cam, vertexXn<0>()->estimate())) -
           _measurement;
}

void EdgeProjectP2SC::linearizeOplus() {
  const SBACam& cam = vertexXn<1>()->estimate();
  const Vector3& point = vertexXn<0>()->estimate();
  linearize(
      cam, point,
      formulas::stereo_image_jacobian(cam.Kcam, baseline_times_focal_length(cam), in_camera(cam, point)),
      _jacobianOplusXi, _jacobianOplusXj);
}

bool EdgeProjectP2SC::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector3>(is, 3, _information,
                                                      [this](const auto& z) { setMeasurement(z); });
}

bool EdgeProjectP2SC::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector3(_measurement), _information);
}

}  // namespace g2o
