// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_xyzprior.h"

#include <algorithm>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::PositionPrior<boxplus::Vector3>;

}  // namespace

EdgeSE3XYZPrior::EdgeSE3XYZPrior() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

bool EdgeSE3XYZPrior::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3XYZPrior)) return true;
  resolveCache(_cache, vertexXn<0>(), "CACHE_SE3_OFFSET", {offsetParam});
  return _cache != nullptr;
}

void EdgeSE3XYZPrior::computeError() {
  _error = Native(adapters::point(_measurement)).error(adapters::pose(*vertexXn<0>()));
}

void EdgeSE3XYZPrior::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()});
}

bool EdgeSE3XYZPrior::read(std::istream& is) {
  return readParamIds(is) &&
         adapters::read_edge<Native>(is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE3XYZPrior::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE3XYZPrior::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE3XYZPrior::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeSE3XYZPrior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().translation());
  return true;
}

double EdgeSE3XYZPrior::initialEstimatePossible(const OptimizableGraph::VertexSet&,
                                                OptimizableGraph::Vertex*) {
  return -1.;
}

void EdgeSE3XYZPrior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  Isometry3 moved = vertexXn<0>()->estimate();
  moved.translation() = _measurement;
  vertexXn<0>()->setEstimate(moved);
}

}  // namespace g2o
