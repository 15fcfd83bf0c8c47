// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/edge_sim3_project_xyz.h"

#include "core/edge_kind.h"
#include "g2o/core/factory.h"
#include "types/adapters.h"
#include "types/exponential.h"
#include "types/images.h"

G2O_USE_TYPE_GROUP(sim3)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

formulas::Pinhole first_camera(const VertexSim3Expmap& v) {
  return {v._focal_length1[0], v._focal_length1[1], v._principle_point1[0], v._principle_point1[1]};
}

formulas::Pinhole second_camera(const VertexSim3Expmap& v) {
  return {v._focal_length2[0], v._focal_length2[1], v._principle_point2[0], v._principle_point2[1]};
}

/// ∂(exp(δ) p)/∂δ for a point p. If the scale is fixed, the column for the scale is zero.
Eigen::Matrix<double, 3, 7> motion_of_point(const VertexSim3Expmap& v, const Vector3& p) {
  Eigen::Matrix<double, 3, 7> J;
  J << formulas::motion_of_point(p), v._fix_scale ? Vector3::Zero() : p;
  return J;
}

}  // namespace

EdgeSim3ProjectXYZ::EdgeSim3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeSim3ProjectXYZ::computeError() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  _error = _measurement - formulas::image(first_camera(v), v.estimate().map(vertexXn<0>()->estimate()));
}

void EdgeSim3ProjectXYZ::linearizeOplus() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  const Sim3& S = v.estimate();
  const Vector3 p = S.map(vertexXn<0>()->estimate());
  const Eigen::Matrix<double, 2, 3> D = formulas::image_jacobian(first_camera(v), p);
  _jacobianOplusXi = -S.scale() * D * S.rotation().toRotationMatrix();
  _jacobianOplusXj = -D * motion_of_point(v, p);
}

bool EdgeSim3ProjectXYZ::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector2>(is, 2, _information,
                                                      [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSim3ProjectXYZ::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

EdgeInverseSim3ProjectXYZ::EdgeInverseSim3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeInverseSim3ProjectXYZ::computeError() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  _error =
      _measurement - formulas::image(second_camera(v), v.estimate().inverse().map(vertexXn<0>()->estimate()));
}

// A step δ of S changes the point in the camera to S⁻¹ exp(−δ) p.
void EdgeInverseSim3ProjectXYZ::linearizeOplus() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  const Sim3 inverse = v.estimate().inverse();
  const Vector3& point = vertexXn<0>()->estimate();
  const Eigen::Matrix<double, 2, 3> D = inverse.scale() *
                                        formulas::image_jacobian(second_camera(v), inverse.map(point)) *
                                        inverse.rotation().toRotationMatrix();
  _jacobianOplusXi = -D;
  _jacobianOplusXj = D * motion_of_point(v, point);
}

bool EdgeInverseSim3ProjectXYZ::read(std::istream& is) {
  return adapters::read_measurement<boxplus::Vector2>(is, 2, _information,
                                                      [this](const auto& z) { setMeasurement(z); });
}

bool EdgeInverseSim3ProjectXYZ::write(std::ostream& os) const {
  return adapters::write_measurement(os, boxplus::Vector2(_measurement), _information);
}

namespace {

const internal::EvaluatedInRuns<EdgeSim3ProjectXYZ> kRunsOfSim3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeInverseSim3ProjectXYZ> kRunsOfInverseSim3ProjectXYZ;

}  // namespace

}  // namespace g2o
