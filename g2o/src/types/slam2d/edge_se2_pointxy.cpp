// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_pointxy.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::PointObservation2;
const ThreadSafe<EdgeSE2PointXY> kThreadSafe;

}  // namespace

EdgeSE2PointXY::EdgeSE2PointXY() {
  _measurement.setZero();
}

void EdgeSE2PointXY::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()));
}

void EdgeSE2PointXY::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()});
}

bool EdgeSE2PointXY::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 2, _information,
                                     [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeSE2PointXY::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE2PointXY::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgeSE2PointXY::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2PointXY::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE2PointXY::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                               OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2PointXY::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * _measurement);
}

}  // namespace g2o
