// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_xy_prior.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::Prior<boxplus::Vector2>;
const ThreadSafe<EdgeXYPrior> kThreadSafe;

}  // namespace

EdgeXYPrior::EdgeXYPrior() {
  _measurement.setZero();
}

void EdgeXYPrior::computeError() {
  _error = Native(adapters::point(_measurement)).error(adapters::point(*vertexXn<0>()));
}

void EdgeXYPrior::linearizeOplus() {
  adapters::linearize(Native(adapters::point(_measurement)),
                      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<0>()),
                                                           std::get<0>(_jacobianOplus).data()});
}

bool EdgeXYPrior::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 2, _information,
                                     [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeXYPrior::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeXYPrior::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgeXYPrior::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeXYPrior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate());
  return true;
}

double EdgeXYPrior::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeXYPrior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<0>()->setEstimate(_measurement);
}

}  // namespace g2o
