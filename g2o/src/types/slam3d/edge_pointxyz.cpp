// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_pointxyz.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::Between<boxplus::Vector3>;
const ThreadSafe<EdgePointXYZ> kThreadSafe;

}  // namespace

EdgePointXYZ::EdgePointXYZ() {
  _measurement.setZero();
}

void EdgePointXYZ::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::point(*vertexXn<0>()), adapters::point(*vertexXn<1>()));
}

void EdgePointXYZ::linearizeOplus() {
  adapters::linearize(Native(adapters::point(_measurement)),
                      adapters::Argument<boxplus::Vector3>{adapters::point(*vertexXn<0>()),
                                                           std::get<0>(_jacobianOplus).data()},
                      adapters::Argument<boxplus::Vector3>{adapters::point(*vertexXn<1>()),
                                                           std::get<1>(_jacobianOplus).data()});
}

bool EdgePointXYZ::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgePointXYZ::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgePointXYZ::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgePointXYZ::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgePointXYZ::setMeasurementFromState() {
  setMeasurement(vertexXn<1>()->estimate() - vertexXn<0>()->estimate());
  return true;
}

double EdgePointXYZ::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgePointXYZ::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() + _measurement);
  } else {
    vertexXn<0>()->setEstimate(vertexXn<1>()->estimate() - _measurement);
  }
}

}  // namespace g2o
