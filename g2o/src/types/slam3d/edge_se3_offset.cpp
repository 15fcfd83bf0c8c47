// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_offset.h"

#include <algorithm>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetBetween<boxplus::SE3>;

}  // namespace

EdgeSE3Offset::EdgeSE3Offset() {
  _measurement.setIdentity();
  _inverseMeasurement.setIdentity();
  resizeParameters(2);
  installParameter(_offsetFrom, 0);
  installParameter(_offsetTo, 1);
}

bool EdgeSE3Offset::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE3Offset)) return true;
  resolveCache(_cacheFrom, vertexXn<0>(), "CACHE_SE3_OFFSET", {_offsetFrom});
  resolveCache(_cacheTo, vertexXn<1>(), "CACHE_SE3_OFFSET", {_offsetTo});
  return _cacheFrom != nullptr && _cacheTo != nullptr;
}

void EdgeSE3Offset::computeError() {
  _error = Native(adapters::pose(_measurement, rotation_.get(_measurement)))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()),
                      adapters::pose(*_offsetFrom), adapters::pose(*_offsetTo));
}

void EdgeSE3Offset::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement, rotation_.get(_measurement))),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*_offsetFrom), nullptr},
      adapters::Argument<boxplus::SE3>{adapters::pose(*_offsetTo), nullptr});
}

bool EdgeSE3Offset::read(std::istream& is) {
  return readParamIds(is) && adapters::read_edge<Native>(is, 7, _information, [this](const auto& z) {
           setMeasurement(adapters::to_g2o(z));
           rotation_.set(adapters::quaternion(z), _measurement.linear());
         });
}

bool EdgeSE3Offset::write(std::ostream& os) const {
  return writeParamIds(os) &&
         adapters::write_edge(os, Native(adapters::pose(_measurement, rotation_.get(_measurement))),
                              _information);
}

void EdgeSE3Offset::setMeasurement(const Isometry3& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
  rotation_.keep(m);
}

bool EdgeSE3Offset::setMeasurementData(const double* d) {
  setMeasurement(internal::fromVectorQT(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSE3Offset::getMeasurementData(double* d) const {
  std::copy_n(adapters::pose(_measurement, rotation_.get(_measurement)).data(), 7, d);
  return true;
}

bool EdgeSE3Offset::setMeasurementFromState() {
  setMeasurement((vertexXn<0>()->estimate() * _offsetFrom->offset()).inverse() *
                 (vertexXn<1>()->estimate() * _offsetTo->offset()));
  return true;
}

double EdgeSE3Offset::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE3Offset::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  const Isometry3 motion = _offsetFrom->offset() * _measurement * _offsetTo->inverseOffset();
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * motion);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() * motion.inverse());
  }
}

}  // namespace g2o
