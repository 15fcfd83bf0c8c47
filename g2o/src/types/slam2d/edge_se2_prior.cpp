// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_prior.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::Prior<boxplus::SE2>;
const ThreadSafe<EdgeSE2Prior> kThreadSafe;

}  // namespace

EdgeSE2Prior::EdgeSE2Prior() = default;

void EdgeSE2Prior::computeError() {
  _error = Native(adapters::pose(_measurement)).error(adapters::pose(*vertexXn<0>()));
}

void EdgeSE2Prior::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()});
}

bool EdgeSE2Prior::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 3, _information,
                                     [this](const auto& z) { setMeasurement(adapters::to_g2o(z)); });
}

bool EdgeSE2Prior::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::pose(_measurement)), _information);
}

void EdgeSE2Prior::setMeasurement(const SE2& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
}

bool EdgeSE2Prior::setMeasurementData(const double* d) {
  setMeasurement(SE2(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE2Prior::getMeasurementData(double* d) const {
  const Vector3 v = _measurement.toVector();
  std::copy_n(v.data(), 3, d);
  return true;
}

bool EdgeSE2Prior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate());
  return true;
}

double EdgeSE2Prior::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE2Prior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<0>()->setEstimate(_measurement);
}

}  // namespace g2o
