// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_xyprior.h"

#include <algorithm>

#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::PositionPrior<boxplus::Vector2>;

}  // namespace

EdgeSE2XYPrior::EdgeSE2XYPrior() {
  _measurement.setZero();
}

void EdgeSE2XYPrior::computeError() {
  _error = Native(adapters::point(_measurement)).error(adapters::pose(*vertexXn<0>()));
}

void EdgeSE2XYPrior::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()});
}

bool EdgeSE2XYPrior::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 2, _information,
                                     [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeSE2XYPrior::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE2XYPrior::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d[0], d[1]));
  return true;
}

bool EdgeSE2XYPrior::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2XYPrior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().translation());
  return true;
}

double EdgeSE2XYPrior::initialEstimatePossible(const OptimizableGraph::VertexSet&,
                                               OptimizableGraph::Vertex*) {
  return -1.;
}

void EdgeSE2XYPrior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<0>()->setEstimate(SE2(_measurement[0], _measurement[1], 0));
}

}  // namespace g2o
