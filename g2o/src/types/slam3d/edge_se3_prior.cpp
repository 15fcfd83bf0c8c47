// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_prior.h"

#include <algorithm>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "types/slam3d/native_slam3d.h"

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
  _error = Native(native::pose(_measurement, rotation_.get(_measurement)))
               .error(native::pose(*vertexXn<0>()), native::pose(*offsetParam));
}

void EdgeSE3Prior::linearizeOplus() {
  native::linearize(
      Native(native::pose(_measurement, rotation_.get(_measurement))),
      native::Argument<boxplus::SE3>{native::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      native::Argument<boxplus::SE3>{native::pose(*offsetParam), nullptr});
}

bool EdgeSE3Prior::read(std::istream& is) {
  return readParamIds(is) && native::read_edge<Native>(is, 7, _information, [this](const auto& z) {
           setMeasurement(native::to_g2o(z));
           rotation_.set(native::quaternion(z), _measurement.linear());
         });
}

bool EdgeSE3Prior::write(std::ostream& os) const {
  return writeParamIds(os) &&
         native::write_edge(os, Native(native::pose(_measurement, rotation_.get(_measurement))),
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
  std::copy_n(native::pose(_measurement, rotation_.get(_measurement)).data(), 7, d);
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
