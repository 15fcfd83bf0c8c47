// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_pointxy_calib.h"

#include <algorithm>

#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetPointObservation2;

}  // namespace

EdgeSE2PointXYCalib::EdgeSE2PointXYCalib() {
  _measurement.setZero();
}

void EdgeSE2PointXYCalib::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()),
                      adapters::pose(*vertexXn<2>()));
}

void EdgeSE2PointXYCalib::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<2>()), std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE2PointXYCalib::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 2, _information,
                                     [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeSE2PointXYCalib::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE2PointXYCalib::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgeSE2PointXYCalib::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2PointXYCalib::setMeasurementFromState() {
  setMeasurement((vertexXn<0>()->estimate() * vertexXn<2>()->estimate()).inverse() *
                 vertexXn<1>()->estimate());
  return true;
}

double EdgeSE2PointXYCalib::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                    OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && from.count(_vertices[2]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2PointXYCalib::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * (vertexXn<2>()->estimate() * _measurement));
}

}  // namespace g2o
