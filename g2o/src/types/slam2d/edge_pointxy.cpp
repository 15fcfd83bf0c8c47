// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_pointxy.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::Between<boxplus::Vector2>;
const ThreadSafe<EdgePointXY> kThreadSafe;

}  // namespace

EdgePointXY::EdgePointXY() {
  _measurement.setZero();
}

void EdgePointXY::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::point(*vertexXn<0>()), adapters::point(*vertexXn<1>()));
}

void EdgePointXY::linearizeOplus() {
  adapters::linearize(Native(adapters::point(_measurement)),
                      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<0>()),
                                                           std::get<0>(_jacobianOplus).data()},
                      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()),
                                                           std::get<1>(_jacobianOplus).data()});
}

bool EdgePointXY::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 2, _information,
                                     [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgePointXY::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgePointXY::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgePointXY::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgePointXY::setMeasurementFromState() {
  setMeasurement(vertexXn<1>()->estimate() - vertexXn<0>()->estimate());
  return true;
}

double EdgePointXY::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgePointXY::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() + _measurement);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() - _measurement);
  }
}

}  // namespace g2o
