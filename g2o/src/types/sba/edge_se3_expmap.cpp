// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sba/edge_se3_expmap.h"

#include <algorithm>

#include "types/exponential.h"
#include "types/sba/adapters_sba.h"

namespace g2o {

EdgeSE3Expmap::EdgeSE3Expmap() = default;

void EdgeSE3Expmap::computeError() {
  _error = (vertexXn<1>()->estimate().inverse() * _measurement * vertexXn<0>()->estimate()).log();
}

// Let E = T₂⁻¹ z T₁. A step δ of T₁ changes E to exp(Ad δ) E with the adjoint Ad of T₂⁻¹ z. A step δ of T₂
// changes E to exp(−Ad δ) E with the adjoint Ad of T₂⁻¹.
void EdgeSE3Expmap::linearizeOplus() {
  const SE3Quat inverse = vertexXn<1>()->estimate().inverse(), left = inverse * _measurement;
  const Matrix6 J = adapters::left_jacobian_of_log(left * vertexXn<0>()->estimate());
  _jacobianOplusXi = J * left.adj();
  _jacobianOplusXj = -J * inverse.adj();
}

bool EdgeSE3Expmap::read(std::istream& is) {
  return adapters::read_measurement<boxplus::SE3>(is, 7, _information, [this](const boxplus::SE3& z) {
    setMeasurement(adapters::to_se3quat(z).inverse());
  });
}

bool EdgeSE3Expmap::write(std::ostream& os) const {
  return adapters::write_measurement(os, adapters::pose(_measurement.inverse()), _information);
}

bool EdgeSE3Expmap::setMeasurementData(const double* d) {
  setMeasurement(SE3Quat(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSE3Expmap::getMeasurementData(double* d) const {
  const Vector7 v = _measurement.toVector();
  std::copy_n(v.data(), 7, d);
  return true;
}

bool EdgeSE3Expmap::setMeasurementFromState() {
  setMeasurement(vertexXn<1>()->estimate() * vertexXn<0>()->estimate().inverse());
  return true;
}

double EdgeSE3Expmap::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSE3Expmap::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(_measurement * vertexXn<0>()->estimate());
  } else {
    vertexXn<0>()->setEstimate(_measurement.inverse() * vertexXn<1>()->estimate());
  }
}

}  // namespace g2o
