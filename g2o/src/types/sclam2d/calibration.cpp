// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/sclam2d/edge_se2_odom_differential_calib.h"
#include "g2o/types/sclam2d/edge_se2_sensor_calib.h"
#include "types/ready_made_edge.h"
#include "types/sclam2d/adapters_sclam2d.h"

namespace g2o {

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

namespace internal {

/// Two poses and a calibration determine each other pose.
template <class Edge>
struct CalibrationModel : GuessedFromOther<Edge> {
  static bool possible(const Edge& e, const OptimizableGraph::VertexSet& from,
                       const OptimizableGraph::Vertex* to) {
    const auto knows = [&](std::size_t i) { return from.count(e.vertices()[i]) > 0; };
    return knows(2) && ((knows(0) && to == e.vertices()[1]) || (knows(1) && to == e.vertices()[0]));
  }
  static SE2 first(const Edge& e) { return estimate<1>(e) * EdgeModel<Edge>::motion(e).inverse(); }
  static SE2 second(const Edge& e) { return estimate<0>(e) * EdgeModel<Edge>::motion(e); }
};

template <>
struct EdgeModel<EdgeSE2SensorCalib> : CalibrationModel<EdgeSE2SensorCalib> {
  using Native = boxplus::OffsetBetween<boxplus::SE2>;
  static SE2 measured(const EdgeSE2SensorCalib& e) {
    const SE2& sensor = estimate<2>(e);
    return (estimate<0>(e) * sensor).inverse() * (estimate<1>(e) * sensor);
  }
  static SE2 motion(const EdgeSE2SensorCalib& e) {
    return estimate<2>(e) * e.measurement() * estimate<2>(e).inverse();
  }
};

template <>
struct EdgeModel<EdgeSE2OdomDifferentialCalib> : CalibrationModel<EdgeSE2OdomDifferentialCalib> {
  using Native = boxplus::WheelOdometry;
  static SE2 motion(const EdgeSE2OdomDifferentialCalib& e) {
    return adapters::to_g2o(Native(adapters::speeds(e.measurement())).motion(native_value(*e.vertexXn<2>())));
  }
};

template struct EdgeFunctions<EdgeSE2SensorCalib>;
template struct EdgeFunctions<EdgeSE2OdomDifferentialCalib>;

}  // namespace internal

EdgeSE2SensorCalib::EdgeSE2SensorCalib() = default;
EdgeSE2OdomDifferentialCalib::EdgeSE2OdomDifferentialCalib() = default;

}  // namespace g2o
