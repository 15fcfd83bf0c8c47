// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/sclam2d/edge_se2_odom_differential_calib.h"
#include "g2o/types/sclam2d/edge_se2_sensor_calib.h"
#include "types/sclam2d/adapters_sclam2d.h"

namespace g2o {
namespace {

using Sensor = boxplus::OffsetBetween<boxplus::SE2>;
using Wheels = boxplus::WheelOdometry;

/// Whether an edge over two poses and a calibration can compute the pose `to`.
bool reaches(HyperGraph::Edge& e, const OptimizableGraph::VertexSet& from, const HyperGraph::Vertex* to) {
  const auto knows = [&](size_t i) { return from.count(e.vertex(i)) > 0; };
  return knows(2) && ((knows(0) && to == e.vertex(1)) || (knows(1) && to == e.vertex(0)));
}

/// Sets the pose `to` of an edge from its other pose and the motion between the two.
template <class Edge>
void move(Edge& e, const OptimizableGraph::Vertex* to, const SE2& motion) {
  VertexSE2 &first = *e.template vertexXn<0>(), &second = *e.template vertexXn<1>();
  if (to == &second) {
    second.setEstimate(first.estimate() * motion);
  } else {
    first.setEstimate(second.estimate() * motion.inverse());
  }
}

}  // namespace

VertexOdomDifferentialParams::VertexOdomDifferentialParams() {
  _estimate = Vector3(1, 1, 1);
}

void VertexOdomDifferentialParams::oplusImpl(double* update) {
  _estimate += Eigen::Map<const Vector3>(update);
}

bool VertexOdomDifferentialParams::read(std::istream& is) {
  boxplus::DifferentialDrive k;
  if (!adapters::read_value(is, 3, k)) return false;
  setEstimate(adapters::to_g2o(k));
  return true;
}

bool VertexOdomDifferentialParams::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::drive(*this));
}

bool VertexOdomDifferentialParams::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 3, est);
  return true;
}

bool VertexOdomDifferentialParams::setEstimateDataImpl(const double* est) {
  _estimate = Eigen::Map<const Vector3>(est);
  return true;
}

EdgeSE2SensorCalib::EdgeSE2SensorCalib() = default;

void EdgeSE2SensorCalib::setMeasurement(const SE2& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
}

void EdgeSE2SensorCalib::computeError() {
  _error = Sensor(adapters::pose(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()),
                      adapters::pose(*vertexXn<2>()));
}

void EdgeSE2SensorCalib::linearizeOplus() {
  adapters::linearize(
      Sensor(adapters::pose(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<2>()), std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE2SensorCalib::read(std::istream& is) {
  return adapters::read_edge<Sensor>(is, 3, _information,
                                     [this](const auto& z) { setMeasurement(adapters::to_g2o(z)); });
}

bool EdgeSE2SensorCalib::write(std::ostream& os) const {
  return adapters::write_edge(os, Sensor(adapters::pose(_measurement)), _information);
}

bool EdgeSE2SensorCalib::setMeasurementData(const double* d) {
  setMeasurement(SE2(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE2SensorCalib::getMeasurementData(double* d) const {
  const Vector3 v = _measurement.toVector();
  std::copy_n(v.data(), 3, d);
  return true;
}

bool EdgeSE2SensorCalib::setMeasurementFromState() {
  const SE2& sensor = vertexXn<2>()->estimate();
  setMeasurement((vertexXn<0>()->estimate() * sensor).inverse() * (vertexXn<1>()->estimate() * sensor));
  return true;
}

double EdgeSE2SensorCalib::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                   OptimizableGraph::Vertex* to) {
  return reaches(*this, from, to) ? 1. : -1.;
}

void EdgeSE2SensorCalib::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex* to) {
  const SE2& sensor = vertexXn<2>()->estimate();
  move(*this, to, sensor * _measurement * sensor.inverse());
}

EdgeSE2OdomDifferentialCalib::EdgeSE2OdomDifferentialCalib() = default;

void EdgeSE2OdomDifferentialCalib::computeError() {
  _error = Wheels(adapters::speeds(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()),
                      adapters::drive(*vertexXn<2>()));
}

void EdgeSE2OdomDifferentialCalib::linearizeOplus() {
  adapters::linearize(
      Wheels(adapters::speeds(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::DifferentialDrive>{adapters::drive(*vertexXn<2>()),
                                                     std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE2OdomDifferentialCalib::read(std::istream& is) {
  return adapters::read_edge<Wheels>(is, 3, _information,
                                     [this](const auto& z) { setMeasurement(adapters::to_g2o(z)); });
}

bool EdgeSE2OdomDifferentialCalib::write(std::ostream& os) const {
  return adapters::write_edge(os, Wheels(adapters::speeds(_measurement)), _information);
}

bool EdgeSE2OdomDifferentialCalib::setMeasurementData(const double* d) {
  setMeasurement(VelocityMeasurement(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE2OdomDifferentialCalib::getMeasurementData(double* d) const {
  d[0] = _measurement.vl();
  d[1] = _measurement.vr();
  d[2] = _measurement.dt();
  return true;
}

double EdgeSE2OdomDifferentialCalib::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                             OptimizableGraph::Vertex* to) {
  return reaches(*this, from, to) ? 1. : -1.;
}

void EdgeSE2OdomDifferentialCalib::initialEstimate(const OptimizableGraph::VertexSet&,
                                                   OptimizableGraph::Vertex* to) {
  move(*this, to,
       adapters::to_g2o(Wheels(adapters::speeds(_measurement)).motion(adapters::drive(*vertexXn<2>()))));
}

}  // namespace g2o
