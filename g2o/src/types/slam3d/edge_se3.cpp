// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::Between<boxplus::SE3>;
const ThreadSafe<EdgeSE3> kThreadSafe;

}  // namespace

EdgeSE3::EdgeSE3() {
  _measurement.setIdentity();
  _inverseMeasurement.setIdentity();
}

void EdgeSE3::computeError() {
  _error = Native(adapters::pose(_measurement, rotation_.get(_measurement)))
               .error(adapters::pose(*vertexXn<0>()), adapters::pose(*vertexXn<1>()));
}

void EdgeSE3::linearizeOplus() {
  adapters::linearize(
      Native(adapters::pose(_measurement, rotation_.get(_measurement))),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<1>()), std::get<1>(_jacobianOplus).data()});
}

bool EdgeSE3::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 7, _information, [this](const auto& z) {
    setMeasurement(adapters::to_g2o(z));
    rotation_.set(adapters::quaternion(z), _measurement.linear());
  });
}

bool EdgeSE3::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::pose(_measurement, rotation_.get(_measurement))),
                              _information);
}

void EdgeSE3::setMeasurement(const Isometry3& m) {
  _measurement = m;
  _inverseMeasurement = m.inverse();
  rotation_.keep(m);
}

bool EdgeSE3::setMeasurementData(const double* d) {
  setMeasurement(internal::fromVectorQT(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSE3::getMeasurementData(double* d) const {
  std::copy_n(adapters::pose(_measurement, rotation_.get(_measurement)).data(), 7, d);
  return true;
}

bool EdgeSE3::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE3::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE3::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * _measurement);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() * _inverseMeasurement);
  }
}

}  // namespace g2o
