// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/slam3d_addons/edge_plane.h"
#include "g2o/types/slam3d_addons/edge_se3_plane_calib.h"
#include "types/ready_made_edge.h"
#include "types/slam3d_addons/adapters_slam3d_addons.h"

namespace g2o {

void Plane3D::oplus(const Vector3& v) {
  fromVector(boxplus::Manifold<boxplus::Plane3>::oplus(adapters::plane(*this), v.data()).coefficients);
}

/// The distance that the engine returns is the distance of the other plane minus the distance of this plane.
Vector3 Plane3D::ominus(const Plane3D& plane) const {
  Vector3 v;
  boxplus::Manifold<boxplus::Plane3>::ominus(adapters::plane(plane), adapters::plane(*this), v.data());
  v[2] = -v[2];
  return v;
}

VertexPlane::VertexPlane() = default;

void VertexPlane::oplusImpl(double* update) {
  _estimate.oplus(Eigen::Map<const Vector3>(update));
}

bool VertexPlane::read(std::istream& is) {
  boxplus::Plane3 plane;
  if (!adapters::read_value(is, 7, plane)) return false;
  color = adapters::color(plane);
  setEstimate(Plane3D(plane.coefficients));
  return true;
}

bool VertexPlane::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::plane(*this));
}

bool VertexPlane::getEstimateData(double* est) const {
  std::copy_n(_estimate.coeffs().data(), 4, est);
  return true;
}

bool VertexPlane::setEstimateDataImpl(const double* est) {
  _estimate.fromVector(Eigen::Map<const Vector4>(est));
  return true;
}

namespace internal {

template <>
struct EdgeModel<EdgePlane> {
  using Native = boxplus::PlaneDifference3;
  static Vector4 measured(const EdgePlane& e) { return estimate<1>(e).coeffs() - estimate<0>(e).coeffs(); }
};

template <>
struct EdgeModel<EdgeSE3PlaneSensorCalib> {
  using Native = boxplus::PlaneObservation3;
  static constexpr int kFields = 7;
  static Native native(const EdgeSE3PlaneSensorCalib& e) {
    return Native(adapters::plane(e.measurement(), e.color));
  }
  static void taken(EdgeSE3PlaneSensorCalib& e, const Native& read) {
    e.color = adapters::color(read.measurement);
  }
  static Plane3D measured(const EdgeSE3PlaneSensorCalib& e) {
    const Isometry3 sensor = estimate<0>(e) * estimate<2>(e);
    return sensor.inverse() * estimate<1>(e);
  }
  static Plane3D second(const EdgeSE3PlaneSensorCalib& e) {
    return estimate<0>(e) * estimate<2>(e) * e.measurement();
  }
};

template struct EdgeFunctions<EdgePlane>;
template struct EdgeFunctions<EdgeSE3PlaneSensorCalib>;

}  // namespace internal

EdgePlane::EdgePlane() = default;
EdgeSE3PlaneSensorCalib::EdgeSE3PlaneSensorCalib() = default;

}  // namespace g2o
