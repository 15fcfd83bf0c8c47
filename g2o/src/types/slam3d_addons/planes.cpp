// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/core/factory.h"
#include "g2o/types/slam3d_addons/edge_plane.h"
#include "g2o/types/slam3d_addons/edge_se3_plane_calib.h"
#include "types/adapters.h"

G2O_USE_TYPE_GROUP(slam3d_addons)  // registers the tags for clients that use only these types

namespace g2o {

VertexPlane::VertexPlane() = default;

void VertexPlane::oplusImpl(double* update) {
  _estimate.oplus(Eigen::Map<const Vector3>(update));
}

bool VertexPlane::read(std::istream& is) {
  boxplus::Vector<double, 7> v;
  if (!adapters::read_value(is, 7, v)) return false;
  color = v.tail<3>();
  setEstimate(Plane3D(v.head<4>()));
  return true;
}

bool VertexPlane::write(std::ostream& os) const {
  boxplus::Vector<double, 7> v;
  v << _estimate.coeffs(), color;
  return adapters::write_value(os, v);
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
  _error = vertexXn<1>()->estimate().coeffs() - vertexXn<0>()->estimate().coeffs() - _measurement;
}

bool EdgePlane::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector<double, 4>>(is, 4, _information,
                                                                [this](const auto& z) { setMeasurement(z); });
}

bool EdgePlane::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector<double, 4>(_measurement), _information);
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
  const Isometry3 sensor = vertexXn<0>()->estimate() * vertexXn<2>()->estimate();
  _error = (sensor.inverse() * vertexXn<1>()->estimate()).ominus(_measurement);
}

bool EdgeSE3PlaneSensorCalib::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector<double, 7>>(is, 7, _information, [this](const auto& v) {
    setMeasurement(Plane3D(v.template head<4>()));
    color = v.template tail<3>();
  });
}

bool EdgeSE3PlaneSensorCalib::write(std::ostream& os) const {
  boxplus::Vector<double, 7> v;
  v << _measurement.coeffs(), color;
  return adapters::write_measurement(os, v, _information);
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
