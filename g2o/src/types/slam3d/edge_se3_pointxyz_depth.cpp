// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_pointxyz_depth.h"

#include <algorithm>

#include "types/images.h"
#include "types/slam3d/native_slam3d.h"

namespace g2o {
namespace {

/// The point in the frame of the camera, beside zero.
using Native = boxplus::OffsetPointObservation3;
const Native kInCamera{boxplus::Vector3(0, 0, 0)};

Vector3 measure(const Matrix3& K, const Vector3& p) {
  Vector3 z;
  z << native::image(K, p), p[2];
  return z;
}

Matrix3 derivative(const Matrix3& K, const Vector3& p) {
  Matrix3 D;
  D << native::image_jacobian(K, p), Vector3::UnitZ().transpose();
  return D;
}

}  // namespace

EdgeSE3PointXYZDepth::EdgeSE3PointXYZDepth() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(params, 0);
}

void EdgeSE3PointXYZDepth::computeError() {
  const Vector3 p =
      kInCamera.error(native::pose(*vertexXn<0>()), native::point(*vertexXn<1>()), native::pose(*params));
  _error = measure(params->Kcam(), p) - _measurement;
}

void EdgeSE3PointXYZDepth::linearizeOplus() {
  const boxplus::SE3 pose = native::pose(*vertexXn<0>()), offset = native::pose(*params);
  const boxplus::Vector3 point = native::point(*vertexXn<1>());
  native::linearize(kInCamera, native::Argument<boxplus::SE3>{pose, _jacobianOplusXi.data()},
                    native::Argument<boxplus::Vector3>{point, _jacobianOplusXj.data()},
                    native::Argument<boxplus::SE3>{offset, nullptr});
  const Matrix3 D = derivative(params->Kcam(), kInCamera.error(pose, point, offset));
  _jacobianOplusXi = (D * _jacobianOplusXi).eval();
  _jacobianOplusXj = (D * _jacobianOplusXj).eval();
}

bool EdgeSE3PointXYZDepth::read(std::istream& is) {
  return readParamIds(is) && native::read_measurement<boxplus::Vector3>(
                                 is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE3PointXYZDepth::write(std::ostream& os) const {
  return writeParamIds(os) && native::write_measurement(os, boxplus::Vector3(_measurement), _information);
}

bool EdgeSE3PointXYZDepth::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE3PointXYZDepth::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeSE3PointXYZDepth::setMeasurementFromState() {
  setMeasurement(measure(
      params->Kcam(), (vertexXn<0>()->estimate() * params->offset()).inverse() * vertexXn<1>()->estimate()));
  return true;
}

double EdgeSE3PointXYZDepth::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                     OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE3PointXYZDepth::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  const Vector3 p = _measurement[2] * (params->invKcam() * Vector3(_measurement[0], _measurement[1], 1));
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * (params->offset() * p));
}

}  // namespace g2o
