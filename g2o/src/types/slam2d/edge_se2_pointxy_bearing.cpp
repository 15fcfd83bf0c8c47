// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_pointxy_bearing.h"

#include <algorithm>
#include <cmath>

#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::BearingObservation2;

}  // namespace

EdgeSE2PointXYBearing::EdgeSE2PointXYBearing() {
  _measurement = 0;
}

void EdgeSE2PointXYBearing::computeError() {
  _error[0] = Native(_measurement).error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()));
}

void EdgeSE2PointXYBearing::linearizeOplus() {
  adapters::linearize(
      Native(_measurement),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()});
}

bool EdgeSE2PointXYBearing::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 1, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE2PointXYBearing::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(_measurement), _information);
}

bool EdgeSE2PointXYBearing::setMeasurementData(const double* d) {
  setMeasurement(d[0]);
  return true;
}

bool EdgeSE2PointXYBearing::getMeasurementData(double* d) const {
  d[0] = _measurement;
  return true;
}

bool EdgeSE2PointXYBearing::setMeasurementFromState() {
  const Vector2 seen = vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate();
  setMeasurement(std::atan2(seen[1], seen[0]));
  return true;
}

double EdgeSE2PointXYBearing::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                      OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2PointXYBearing::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  constexpr double kDistance = 2;  // arbitrary, because a bearing does not measure the distance
  const Vector2 seen(kDistance * std::cos(_measurement), kDistance * std::sin(_measurement));
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * seen);
}

}  // namespace g2o
