// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_xyz_prior.h"

#include <algorithm>

#include "g2o/core/thread_safe.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::Prior<boxplus::Vector3>;
const ThreadSafe<EdgeXYZPrior> kThreadSafe;

}  // namespace

EdgeXYZPrior::EdgeXYZPrior() {
  _measurement.setZero();
}

void EdgeXYZPrior::computeError() {
  _error = Native(adapters::point(_measurement)).error(adapters::point(*vertexXn<0>()));
}

void EdgeXYZPrior::linearizeOplus() {
  adapters::linearize(Native(adapters::point(_measurement)),
                      adapters::Argument<boxplus::Vector3>{adapters::point(*vertexXn<0>()),
                                                           std::get<0>(_jacobianOplus).data()});
}

bool EdgeXYZPrior::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeXYZPrior::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeXYZPrior::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgeXYZPrior::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeXYZPrior::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate());
  return true;
}

double EdgeXYZPrior::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeXYZPrior::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<0>()->setEstimate(_measurement);
}

}  // namespace g2o
