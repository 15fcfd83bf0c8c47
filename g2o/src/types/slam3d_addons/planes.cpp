// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/slam3d_addons/edge_plane.h"
#include "g2o/types/slam3d_addons/edge_se3_plane_calib.h"
#include "types/slam3d_addons/adapters_slam3d_addons.h"

namespace g2o {
namespace {

using Observation = boxplus::PlaneObservation3;
using Difference = boxplus::PlaneDifference3;

}  // namespace

void Plane3D::oplus(const Vector3& v) {
  fromVector(boxplus::Manifold<boxplus::Plane3>::oplus(adapters::plane(*this), v.data()).coefficients);
}

/// The distance that the engine returns is the distance of the other plane minus the distance of this plane.
Vector3 Plane3D::ominus(const Plane3D& plane) const {
  Vector3 v;
  boxplus::Manifold<boxplus::Plane3>::ominus(adapters::plane(plane), adapters::plane(*this), v.data());
  v[2] = -v[2];
  return v;
}

VertexPlane::VertexPlane() = default;

void VertexPlane::oplusImpl(double* update) {
  _estimate.oplus(Eigen::Map<const Vector3>(update));
}

bool VertexPlane::read(std::istream& is) {
  boxplus::Plane3 plane;
  if (!adapters::read_value(is, 7, plane)) return false;
  color = adapters::color(plane);
  setEstimate(Plane3D(plane.coefficients));
  return true;
}

bool VertexPlane::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::plane(*this));
}

bool VertexPlane::getEstimateData(double* est) const {
  std::copy_n(_estimate.coeffs().data(), 4, est);
  return true;
}

bool VertexPlane::setEstimateDataImpl(const double* est) {
  _estimate.fromVector(Eigen::Map<const Vector4>(est));
  return true;
}

EdgePlane::EdgePlane() {
  _measurement.setZero();
}

void EdgePlane::computeError() {
  _error = Difference(_measurement)
               .error(adapters::plane(vertexXn<0>()->estimate()), adapters::plane(vertexXn<1>()->estimate()));
}

void EdgePlane::linearizeOplus() {
  adapters::linearize(Difference(_measurement),
                      adapters::Argument<boxplus::Plane3>{adapters::plane(vertexXn<0>()->estimate()),
                                                          _jacobianOplusXi.data()},
                      adapters::Argument<boxplus::Plane3>{adapters::plane(vertexXn<1>()->estimate()),
                                                          _jacobianOplusXj.data()});
}

bool EdgePlane::read(std::istream& is) {
  return adapters::read_edge<Difference>(is, 4, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgePlane::write(std::ostream& os) const {
  return adapters::write_edge(os, Difference(_measurement), _information);
}

bool EdgePlane::setMeasurementData(const double* d) {
  setMeasurement(Vector4(d));
  return true;
}

bool EdgePlane::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 4, d);
  return true;
}

bool EdgePlane::setMeasurementFromState() {
  setMeasurement(vertexXn<1>()->estimate().coeffs() - vertexXn<0>()->estimate().coeffs());
  return true;
}

EdgeSE3PlaneSensorCalib::EdgeSE3PlaneSensorCalib() = default;

void EdgeSE3PlaneSensorCalib::computeError() {
  _error = Observation(adapters::plane(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::plane(vertexXn<1>()->estimate()),
                      adapters::pose(*vertexXn<2>()));
}

void EdgeSE3PlaneSensorCalib::linearizeOplus() {
  adapters::linearize(
      Observation(adapters::plane(_measurement)),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Plane3>{adapters::plane(vertexXn<1>()->estimate()),
                                          std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<2>()), std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE3PlaneSensorCalib::read(std::istream& is) {
  return adapters::read_edge<Observation>(is, 7, _information, [this](const auto& z) {
    setMeasurement(Plane3D(z.coefficients));
    color = adapters::color(z);
  });
}

bool EdgeSE3PlaneSensorCalib::write(std::ostream& os) const {
  return adapters::write_edge(os, Observation(adapters::plane(_measurement, color)), _information);
}

bool EdgeSE3PlaneSensorCalib::setMeasurementData(const double* d) {
  setMeasurement(Plane3D(Vector4(d)));
  return true;
}

bool EdgeSE3PlaneSensorCalib::getMeasurementData(double* d) const {
  std::copy_n(_measurement.coeffs().data(), 4, d);
  return true;
}

bool EdgeSE3PlaneSensorCalib::setMeasurementFromState() {
  const Isometry3 sensor = vertexXn<0>()->estimate() * vertexXn<2>()->estimate();
  setMeasurement(sensor.inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE3PlaneSensorCalib::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                        OptimizableGraph::Vertex* to) {
  const bool knows_sensor = from.count(_vertices[0]) > 0 && from.count(_vertices[2]) > 0;
  return knows_sensor && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE3PlaneSensorCalib::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * vertexXn<2>()->estimate() * _measurement);
}

}  // namespace g2o
