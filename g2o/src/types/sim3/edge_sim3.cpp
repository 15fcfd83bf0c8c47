// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/edge_sim3.h"

#include "g2o/core/factory.h"
#include "types/adapters.h"
#include "types/exponential.h"
#include "types/sim3/usable_sim3.h"

G2O_USE_TYPE_GROUP(sim3)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

/// The adjoint of S: the matrix Ad with exp(Ad δ) = S exp(δ) S⁻¹.
Matrix7 adjoint(const Sim3& S) {
  const Matrix3 R = S.rotation().toRotationMatrix();
  Matrix7 Ad = Matrix7::Zero();
  Ad.topLeftCorner<3, 3>() = R;
  Ad.block<3, 3>(3, 0) = skew(S.translation()) * R;
  Ad.block<3, 3>(3, 3) = S.scale() * R;
  Ad.block<3, 1>(3, 6) = -S.translation();
  Ad(6, 6) = 1;
  return Ad;
}

}  // namespace

EdgeSim3::EdgeSim3() = default;

void EdgeSim3::computeError() {
  _error = (_measurement * vertexXn<0>()->estimate() * vertexXn<1>()->estimate().inverse()).log();
}

// Let E = z S₁ S₂⁻¹. A step δ of S₁ changes E to exp(Ad_z δ) E. A step δ of S₂ changes E to E exp(−δ) =
// exp(−Ad_E δ) E.
void EdgeSim3::linearizeOplus() {
  const VertexSim3Expmap *first = vertexXn<0>(), *second = vertexXn<1>();
  const Sim3 E = _measurement * first->estimate() * second->estimate().inverse();
  const Matrix7 J =
      adapters::left_jacobian_of_log(adapters::similarity(E.rotation(), E.translation(), E.scale()));
  _jacobianOplusXi = J * adjoint(_measurement);
  _jacobianOplusXj = -J * adjoint(E);
  if (first->_fix_scale) _jacobianOplusXi.col(6).setZero();
  if (second->_fix_scale) _jacobianOplusXj.col(6).setZero();
}

bool EdgeSim3::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector<double, 7>>(is, 7, _information, [this](const auto& z) {
    const Sim3 measured(Vector7{z});
    if (!adapters::is_usable(measured)) throw boxplus::Error(adapters::kExpectedUsableSim3);
    setMeasurement(measured.inverse());
  });
}

bool EdgeSim3::write(std::ostream& os) const {
  if (!adapters::is_usable(_measurement)) return false;
  return adapters::write_measurement(os, boxplus::Vector<double, 7>(_measurement.inverse().log()),
                                     _information);
}

bool EdgeSim3::setMeasurementFromState() {
  setMeasurement(vertexXn<1>()->estimate() * vertexXn<0>()->estimate().inverse());
  return true;
}

double EdgeSim3::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSim3::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  if (from.count(_vertices[0]) > 0) {
    vertexXn<1>()->setEstimate(_measurement * vertexXn<0>()->estimate());
  } else {
    vertexXn<0>()->setEstimate(_measurement.inverse() * vertexXn<1>()->estimate());
  }
}

}  // namespace g2o
