// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_offset.h"

#include <algorithm>
#include <typeinfo>

#include "g2o/core/cache.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetBetween<boxplus::SE2>;

}  // namespace

EdgeSE2Offset::EdgeSE2Offset() {
  resizeParameters(2);
  installParameter(_offsetFrom, 0);
  installParameter(_offsetTo, 1);
}

bool EdgeSE2Offset::resolveCaches() {
  if (typeid(*this) == typeid(EdgeSE2Offset)) return true;
  resolveCache(_cacheFrom, vertexXn<0>(), "CACHE_SE2_OFFSET", {_offsetFrom});
  resolveCache(_cacheTo, vertexXn<1>(), "CACHE_SE2_OFFSET", {_offsetTo});
  return _cacheFrom != nullptr && _cacheTo != nullptr;
}

void EdgeSE2Offset::computeError() {
  _error = Native(adapters::pose(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()),
                      adapters::pose(_offsetFrom->offset()), adapters::pose(_offsetTo->offset()));
}

void EdgeSE2Offset::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(_offsetFrom->offset()), nullptr},
      adapters::Argument<boxplus::SE2>{adapters::pose(_offsetTo->offset()), nullptr});
}

bool EdgeSE2Offset::read(std::istream& is) {
  return readParamIds(is) && adapters::read_edge<Native>(is, 3, _information, [this](const auto& z) {
           setMeasurement(adapters::to_g2o(z));
         });
}

bool EdgeSE2Offset::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_edge(os, Native(adapters::pose(_measurement)), _information);
}

void EdgeSE2Offset::setMeasurement(const SE2& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
}

bool EdgeSE2Offset::setMeasurementData(const double* d) {
  setMeasurement(SE2(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE2Offset::getMeasurementData(double* d) const {
  const Vector3 v = _measurement.toVector();
  std::copy_n(v.data(), 3, d);
  return true;
}

bool EdgeSE2Offset::setMeasurementFromState() {
  setMeasurement((vertexXn<0>()->estimate() * _offsetFrom->offset()).inverse() *
                 (vertexXn<1>()->estimate() * _offsetTo->offset()));
  return true;
}

double EdgeSE2Offset::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE2Offset::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  const SE2 motion = _offsetFrom->offset() * _measurement * _offsetTo->offset().inverse();
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * motion);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() * motion.inverse());
  }
}

}  // namespace g2o
