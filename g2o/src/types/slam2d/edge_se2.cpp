// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

using Native = boxplus::Between<boxplus::SE2>;
const ThreadSafe<EdgeSE2> kThreadSafe;

}  // namespace

EdgeSE2::EdgeSE2() = default;

void EdgeSE2::computeError() {
  _error = Native(adapters::pose(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()));
}

void EdgeSE2::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement)),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()});
}

bool EdgeSE2::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 3, _information,
                                     [this](const auto& z) { setMeasurement(adapters::to_g2o(z)); });
}

bool EdgeSE2::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::pose(_measurement)), _information);
}

void EdgeSE2::setMeasurement(const SE2& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
}

bool EdgeSE2::setMeasurementData(const double* d) {
  setMeasurement(SE2(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE2::getMeasurementData(double* d) const {
  const Vector3 v = _measurement.toVector();
  std::copy_n(v.data(), 3, d);
  return true;
}

bool EdgeSE2::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE2::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE2::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * _measurement);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() * _inverseMeasurement);
  }
}

}  // namespace g2o
