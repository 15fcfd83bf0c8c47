// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sba/vertex_cam.h"

#include <algorithm>

#include "g2o/types/sba/vertex_intrinsics.h"
#include "types/sba/adapters_se3quat.h"

namespace g2o {

SBACam::SBACam() : SBACam(SE3Quat()) {}

SBACam::SBACam(const Quaternion& r, const Vector3& t) : SBACam(SE3Quat(r, t)) {}

SBACam::SBACam(const SE3Quat& p) : SE3Quat(p) {
  setKcam(1, 1, 0.5, 0.5, 0);
}

void SBACam::update(const Vector6& update) {
  const boxplus::detail::Quaternion<double> step =
      boxplus::detail::QuaternionChart::exp(update[3], update[4], update[5]);
  _t += update.head<3>();
  _r *= Quaternion(step.w, step.x, step.y, step.z);
  _r.normalize();
  setTransform();
  setProjection();
  setDr();
}

void SBACam::transformW2F(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot) {
  m.leftCols<3>() = qrot.toRotationMatrix().transpose();
  m.col(3) = -m.leftCols<3>() * trans;
}

void SBACam::transformF2W(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot) {
  m.leftCols<3>() = qrot.toRotationMatrix();
  m.col(3) = trans;
}

void SBACam::setKcam(double fx, double fy, double cx, double cy, double tx) {
  Kcam = adapters::camera_matrix(fx, fy, cx, cy);
  baseline = tx;
  setTransform();
  setProjection();
  setDr();
}

void SBACam::setTransform() {
  transformW2F(w2n, _t, _r);
}

void SBACam::setProjection() {
  w2i = Kcam * w2n;
}

void SBACam::setDr() {
  adapters::rotation_derivatives(w2n.leftCols<3>(), dRdx, dRdy, dRdz);
}

std::ostream& operator<<(std::ostream& os, const SBACam& cam) {
  return os << cam.translation().transpose() << ' ' << cam.rotation().coeffs().transpose() << "\n\n"
            << cam.Kcam << "\n\n"
            << cam.baseline << '\n';
}

VertexCam::VertexCam() = default;

void VertexCam::setEstimate(const SBACam& cam) {
  SBACam current = cam;
  current.setTransform();
  current.setProjection();
  current.setDr();
  BaseVertex<6, SBACam>::setEstimate(current);
}

void VertexCam::setToOriginImpl() {
  SBACam cam = _estimate;
  cam.setRotation(Quaternion::Identity());
  cam.setTranslation(Vector3::Zero());
  setEstimate(cam);
}

void VertexCam::oplusImpl(double* update) {
  _estimate.update(Eigen::Map<const Vector6>(update));
}

bool VertexCam::read(std::istream& is) {
  boxplus::SE3 x;
  if (!adapters::read_value(is, 7, x)) return false;
  double fx = 300, fy = 300, cx = 320, cy = 320, baseline = 0.1;
  if (!adapters::read_rest(is, {&fx, &fy, &cx, &cy, &baseline})) return false;
  SBACam cam(adapters::to_se3quat(x));
  cam.setKcam(fx, fy, cx, cy, baseline);
  setEstimate(cam);
  return true;
}

bool VertexCam::write(std::ostream& os) const {
  const Matrix3& K = _estimate.Kcam;
  return adapters::write_value(os, adapters::pose(_estimate)) &&
         adapters::write_rest(os, {K(0, 0), K(1, 1), K(0, 2), K(1, 2), _estimate.baseline});
}

bool VertexCam::getEstimateData(double* est) const {
  const Vector7 v = _estimate.toVector();
  std::copy_n(v.data(), 7, est);
  return true;
}

bool VertexCam::getMinimalEstimateData(double* est) const {
  const Vector6 v = _estimate.toMinimalVector();
  std::copy_n(v.data(), 6, est);
  return true;
}

bool VertexCam::setEstimateDataImpl(const double* est) {
  SBACam moved = _estimate;
  moved.fromVector(Eigen::Map<const Vector7>(est));
  setEstimate(moved);
  return true;
}

bool VertexCam::setMinimalEstimateDataImpl(const double* est) {
  SBACam moved = _estimate;
  moved.fromMinimalVector(Eigen::Map<const Vector6>(est));
  setEstimate(moved);
  return true;
}

VertexIntrinsics::VertexIntrinsics() {
  VertexIntrinsics::setToOriginImpl();
}

void VertexIntrinsics::setToOriginImpl() {
  _estimate << 1, 1, 0.5, 0.5, 0.1;
}

void VertexIntrinsics::oplusImpl(double* update) {
  _estimate.head<4>() += Eigen::Map<const Vector4>(update);
}

bool VertexIntrinsics::read(std::istream& is) {
  boxplus::Vector<double, 5> v;
  if (!adapters::read_value(is, 5, v)) return false;
  setEstimate(v);
  return true;
}

bool VertexIntrinsics::write(std::ostream& os) const {
  return adapters::write_value(os, boxplus::Vector<double, 5>(_estimate));
}

}  // namespace g2o
