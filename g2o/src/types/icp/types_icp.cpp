// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/icp/types_icp.h"

#include "g2o/core/factory.h"
#include "types/ready_made_edge.h"
#include "types/slam3d/adapters_slam3d.h"
#include "types/slam3d/cameras.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(icp);
G2O_USE_TYPE_GROUP(icp_actions);
G2O_REGISTER_TYPE(EDGE_V_V_GICP, Edge_V_V_GICP);

namespace {

Matrix3 turned(const Matrix3& R, double across, double along) {
  return R.transpose() * Vector3(across, across, along).asDiagonal() * R;
}

boxplus::SurfaceMatch native(const EdgeGICP& z) {
  return {z.pos0, z.normal0, z.pos1, z.normal1};
}

}  // namespace

EdgeGICP::EdgeGICP() = default;

void EdgeGICP::makeRot0() {
  R0 = boxplus::detail::frame_of_normal(normal0);
}
void EdgeGICP::makeRot1() {
  R1 = boxplus::detail::frame_of_normal(normal1);
}

Matrix3 EdgeGICP::prec0(double e) {
  makeRot0();
  return turned(R0, e, 1);
}
Matrix3 EdgeGICP::prec1(double e) {
  makeRot1();
  return turned(R1, e, 1);
}
Matrix3 EdgeGICP::cov0(double e) {
  makeRot0();
  return turned(R0, 1, e);
}
Matrix3 EdgeGICP::cov1(double e) {
  makeRot1();
  return turned(R1, 1, e);
}

Edge_V_V_GICP::Edge_V_V_GICP(const Edge_V_V_GICP* e) : pl_pl(e->pl_pl), cov0(e->cov0), cov1(e->cov1) {
  _vertices = e->_vertices;
  _measurement = e->_measurement;
}

void Edge_V_V_GICP::computeError() {
  const VertexSE3 &first = *vertexXn<0>(), &second = *vertexXn<1>();
  _error = native(_measurement).error(adapters::pose(first), adapters::pose(second));
  if (!pl_pl) return;
  const Matrix3 R = first.estimate().linear().transpose() * second.estimate().linear();
  _information = (cov0 + R * cov1 * R.transpose()).inverse();
}

void Edge_V_V_GICP::linearizeOplus() {
  adapters::linearize(
      native(_measurement),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), _jacobianOplusXi.data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<1>()), _jacobianOplusXj.data()});
}

bool Edge_V_V_GICP::read(std::istream& is) {
  boxplus::Vector<double, 12> v;
  if (!adapters::read_value(is, 12, v)) return false;
  EdgeGICP z;
  z.pos0 = v.segment<3>(0);
  z.normal0 = v.segment<3>(3);
  z.pos1 = v.segment<3>(6);
  z.normal1 = v.segment<3>(9);
  z.makeRot0();
  z.makeRot1();
  setMeasurement(z);
  setInformation(z.prec0(boxplus::SurfaceMatch::kAcross));  // files do not store Ω
  return true;
}

bool Edge_V_V_GICP::write(std::ostream& os) const {
  boxplus::Vector<double, 12> v;
  v << _measurement.pos0, _measurement.normal0, _measurement.pos1, _measurement.normal1;
  return adapters::write_value(os, v);
}

namespace {

double baseline_times_focal_length() {
  return VertexSCam::Kcam(0, 0) * VertexSCam::baseline;
}

}  // namespace

Matrix3 VertexSCam::Kcam = adapters::camera_matrix(1, 1, 0, 0);
double VertexSCam::baseline = 0;

VertexSCam::VertexSCam() {
  setAll();
}

void VertexSCam::transformW2F(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot) {
  SBACam::transformW2F(m, trans, qrot);
}

void VertexSCam::transformF2W(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot) {
  SBACam::transformF2W(m, trans, qrot);
}

void VertexSCam::setKcam(double fx, double fy, double cx, double cy, double tx) {
  Kcam = adapters::camera_matrix(fx, fy, cx, cy);
  baseline = tx;
}

void VertexSCam::setTransform() {
  w2n = _estimate.inverse().matrix().topRows<3>();
}

void VertexSCam::setProjection() {
  w2i = Kcam * w2n;
}

void VertexSCam::setDr() {
  adapters::rotation_derivatives(w2n.leftCols<3>(), dRdx, dRdy, dRdz);
}

void VertexSCam::setAll() {
  setTransform();
  setProjection();
  setDr();
}

void VertexSCam::mapPoint(Vector3& res, const Vector3& pt3) const {
  res = adapters::image<3>(Kcam, baseline_times_focal_length(), adapters::pose(*this).inverse_times(pt3));
}

namespace internal {

template <>
struct EdgeModel<Edge_XYZ_VSC> {
  static Vector3 error(const Edge_XYZ_VSC& e) {
    Vector3 image;
    e.vertexXn<1>()->mapPoint(image, estimate<0>(e));
    return image - e.measurement();
  }
  static void linearize(Edge_XYZ_VSC& e) {
    const boxplus::SE3 pose = adapters::pose(*e.vertexXn<1>());
    const boxplus::Vector3 point = estimate<0>(e), p = pose.inverse_times(point);
    const Matrix3 D = adapters::image_by_point<3>(VertexSCam::Kcam, baseline_times_focal_length(), p);
    auto& Xi = e.jacobianOplusXn<0>();
    auto& Xj = e.jacobianOplusXn<1>();
    boxplus::PointObservation3(p).jacobians(pose, point, Xj, Xi);
    Xi = (D * Xi).eval();
    Xj = (D * Xj).eval();
  }
};

template struct EdgeFunctions<Edge_XYZ_VSC>;

}  // namespace internal

Edge_XYZ_VSC::Edge_XYZ_VSC() = default;

}  // namespace g2o
