// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_prior.h"

#include <algorithm>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetPrior<boxplus::SE3>;

}  // namespace

EdgeSE3Prior::EdgeSE3Prior() {
  _measurement.setIdentity();
  _inverseMeasurement.setIdentity();
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

bool EdgeSE3Prior::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3Prior)) return true;
  resolveCache(_cache, vertexXn<0>(), "CACHE_SE3_OFFSET", {offsetParam});
  return _cache != nullptr;
}

void EdgeSE3Prior::computeError() {
  _error = Native(adapters::pose(_measurement, rotation_.get(_measurement)))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*offsetParam));
}

void EdgeSE3Prior::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement, rotation_.get(_measurement))),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*offsetParam), nullptr});
}

bool EdgeSE3Prior::read(std::istream& is) {
  return readParamIds(is) && adapters::read_edge<Native>(is, 7, _information, [this](const auto& z) {
           setMeasurement(adapters::to_g2o(z));
           rotation_.set(adapters::quaternion(z), _measurement.linear());
         });
}

bool EdgeSE3Prior::write(std::ostream& os) const {
  return writeParamIds(os) &&
         adapters::write_edge(os, Native(adapters::pose(_measurement, rotation_.get(_measurement))),
                              _information);
}

void EdgeSE3Prior::setMeasurement(const Isometry3& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
  rotation_.keep(m);
}

bool EdgeSE3Prior::setMeasurementData(const double* d) {
  setMeasurement(internal::fromVectorQT(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSE3Prior::getMeasurementData(double* d) const {
  std::copy_n(adapters::pose(_measurement, rotation_.get(_measurement)).data(), 7, d);
  return true;
}

bool EdgeSE3Prior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate() * offsetParam->offset());
  return true;
}

double EdgeSE3Prior::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE3Prior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<0>()->setEstimate(_measurement * offsetParam->inverseOffset());
}

}  // namespace g2o
