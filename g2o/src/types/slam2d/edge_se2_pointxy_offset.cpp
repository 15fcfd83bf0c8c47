// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_pointxy_offset.h"

#include <algorithm>

#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetPointObservation2;

}  // namespace

EdgeSE2PointXYOffset::EdgeSE2PointXYOffset() {
  resizeParameters(1);
  installParameter(_offsets[0], 0);
  _measurement.setZero();
}

void EdgeSE2PointXYOffset::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()),
                      adapters::pose(_offsets[0]->offset()));
}

void EdgeSE2PointXYOffset::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(_offsets[0]->offset()), nullptr});
}

bool EdgeSE2PointXYOffset::read(std::istream& is) {
  return readParamIds(is) && adapters::read_edge<Native>(
                                 is, 2, _information, [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeSE2PointXYOffset::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE2PointXYOffset::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgeSE2PointXYOffset::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2PointXYOffset::setMeasurementFromState() {
  setMeasurement((vertexXn<0>()->estimate() * _offsets[0]->offset()).inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE2PointXYOffset::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                     OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2PointXYOffset::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * (_offsets[0]->offset() * _measurement));
}

}  // namespace g2o
