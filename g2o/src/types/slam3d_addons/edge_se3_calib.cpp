// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d_addons/edge_se3_calib.h"

#include <algorithm>

#include "g2o/core/factory.h"
#include "types/slam3d/adapters_slam3d.h"

G2O_USE_TYPE_GROUP(slam3d_addons)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

using Native = boxplus::OffsetBetween<boxplus::SE3>;

}  // namespace

EdgeSE3Calib::EdgeSE3Calib() {
  _measurement.setIdentity();
}

void EdgeSE3Calib::computeError() {
  _error = Native(adapters::pose(_measurement, rotation_.get(_measurement)))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()),
                      adapters::pose(*vertexXn<2>()));
}

void EdgeSE3Calib::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement, rotation_.get(_measurement))),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<2>()), std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE3Calib::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 7, _information, [this](const auto& z) {
    setMeasurement(adapters::to_g2o(z));
    rotation_.set(adapters::quaternion(z), _measurement.linear());
  });
}

bool EdgeSE3Calib::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::pose(_measurement, rotation_.get(_measurement))),
                              _information);
}

bool EdgeSE3Calib::setMeasurementData(const double* d) {
  setMeasurement(internal::fromVectorQT(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSE3Calib::getMeasurementData(double* d) const {
  std::copy_n(adapters::pose(_measurement, rotation_.get(_measurement)).data(), 7, d);
  return true;
}

bool EdgeSE3Calib::setMeasurementFromState() {
  const Isometry3& sensor = vertexXn<2>()->estimate();
  setMeasurement((vertexXn<0>()->estimate() * sensor).inverse() * (vertexXn<1>()->estimate() * sensor));
  return true;
}

double EdgeSE3Calib::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                             OptimizableGraph::Vertex* to) {
  return from.count(_vertices[2]) > 0 && to != _vertices[2] ? 1. : -1.;
}

void EdgeSE3Calib::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex* to) {
  const Isometry3& sensor = vertexXn<2>()->estimate();
  const Isometry3 motion = sensor * _measurement * sensor.inverse();
  if (to == vertexXn<1>()) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * motion);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() * motion.inverse());
  }
}

}  // namespace g2o
