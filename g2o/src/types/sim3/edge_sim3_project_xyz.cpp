// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/edge_sim3_project_xyz.h"

#include "core/edge_kind.h"
#include "g2o/core/factory.h"
#include "types/adapters.h"
#include "types/cameras.h"

G2O_USE_TYPE_GROUP(sim3)  // registers the tags for clients that use only these types

namespace g2o {
namespace {

adapters::Pinhole first_camera(const VertexSim3Expmap& v) {
  return adapters::pinhole(v._focal_length1[0], v._focal_length1[1], v._principle_point1[0],
                           v._principle_point1[1]);
}

adapters::Pinhole second_camera(const VertexSim3Expmap& v) {
  return adapters::pinhole(v._focal_length2[0], v._focal_length2[1], v._principle_point2[0],
                           v._principle_point2[1]);
}

}  // namespace

EdgeSim3ProjectXYZ::EdgeSim3ProjectXYZ() {
  _measurement.setZero();
}

void EdgeSim3ProjectXYZ::computeError() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  _error = _measurement - first_camera(v).image<2>(v.estimate().map(vertexXn<0>()->estimate()));
}

// A change of the scale moves the point in the frame of the camera along its ray, so its image stays.
void EdgeSim3ProjectXYZ::linearizeOplus() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  const Sim3& S = v.estimate();
  const Vector3 p = S.map(vertexXn<0>()->estimate());
  const adapters::ImageDerivatives<2> by(first_camera(v), p);
  by.by_rotated_point(-S.scale() * S.rotation().toRotationMatrix(), _jacobianOplusXi);
  by.by_pose(_jacobianOplusXj.middleCols<3>(3), _jacobianOplusXj.leftCols<3>());
  _jacobianOplusXj.col(6).setZero();
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
  _error = _measurement - second_camera(v).image<2>(v.estimate().inverse().map(vertexXn<0>()->estimate()));
}

// A step δ of S changes the point in the camera to S⁻¹ exp(−δ) p.
void EdgeInverseSim3ProjectXYZ::linearizeOplus() {
  const VertexSim3Expmap& v = *vertexXn<1>();
  const Sim3 inverse = v.estimate().inverse();
  const Vector3& point = vertexXn<0>()->estimate();
  Eigen::Matrix<double, 2, 3> D;  // of the image, by the point
  adapters::ImageDerivatives<2>(second_camera(v), inverse.map(point))
      .by_rotated_point(inverse.scale() * inverse.rotation().toRotationMatrix(), D);
  _jacobianOplusXi = -D;
  _jacobianOplusXj << -D * skew(point), D, D * point;
  if (v._fix_scale) _jacobianOplusXj.col(6).setZero();
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
