// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_twopointsxy.h"

#include <algorithm>

#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::TwoPointsObservation2;

}  // namespace

EdgeSE2TwoPointsXY::EdgeSE2TwoPointsXY() {
  _measurement.setZero();
}

void EdgeSE2TwoPointsXY::computeError() {
  _error = Native(boxplus::Vector<double, 4>(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()),
                      adapters::point(*vertexXn<2>()));
}

void EdgeSE2TwoPointsXY::linearizeOplus() {
  adapters::linearize(
      Native(boxplus::Vector<double, 4>(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<2>()),
                                           std::get<2>(_jacobianOplus).data()});
}

bool EdgeSE2TwoPointsXY::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 4, _information,
                                     [this](const auto& z) { setMeasurement(Vector4(z)); });
}

bool EdgeSE2TwoPointsXY::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(boxplus::Vector<double, 4>(_measurement)), _information);
}

bool EdgeSE2TwoPointsXY::setMeasurementData(const double* d) {
  setMeasurement(Vector4(d));
  return true;
}

bool EdgeSE2TwoPointsXY::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 4, d);
  return true;
}

bool EdgeSE2TwoPointsXY::setMeasurementFromState() {
  const SE2 inverse = vertexXn<0>()->estimate().inverse();
  Vector4 z;
  z << inverse * vertexXn<1>()->estimate(), inverse * vertexXn<2>()->estimate();
  setMeasurement(z);
  return true;
}

double EdgeSE2TwoPointsXY::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                   OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to != vertexXn<0>() ? 1. : -1.;
}

void EdgeSE2TwoPointsXY::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex* to) {
  const SE2& x = vertexXn<0>()->estimate();
  if (to == vertexXn<1>()) vertexXn<1>()->setEstimate(x * Vector2(_measurement.head<2>()));
  if (to == vertexXn<2>()) vertexXn<2>()->setEstimate(x * Vector2(_measurement.tail<2>()));
}

}  // namespace g2o
