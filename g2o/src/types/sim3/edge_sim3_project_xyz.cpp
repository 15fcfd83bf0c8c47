// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/edge_sim3_project_xyz.h"

#include "core/edge_kind.h"
#include "g2o/core/factory.h"
#include "types/ready_made_edge.h"
#include "types/slam3d/cameras.h"

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

namespace internal {

template <>
struct EdgeModel<EdgeSim3ProjectXYZ> {
  static Vector2 error(const EdgeSim3ProjectXYZ& e) {
    return e.measurement() - first_camera(*e.vertexXn<1>()).image<2>(estimate<1>(e).map(estimate<0>(e)));
  }
  // A change of the scale moves the point in the frame of the camera along its ray, so its image stays.
  static void linearize(EdgeSim3ProjectXYZ& e) {
    const Sim3& S = estimate<1>(e);
    const Vector3 p = S.map(estimate<0>(e));
    const adapters::ImageDerivatives<2> by(first_camera(*e.vertexXn<1>()), p);
    auto& by_pose = e.jacobianOplusXn<1>();
    by.by_rotated_point(-S.scale() * S.rotation().toRotationMatrix(), e.jacobianOplusXn<0>());
    by.by_pose(by_pose.middleCols<3>(3), by_pose.leftCols<3>());
    by_pose.col(6).setZero();
  }
};

template <>
struct EdgeModel<EdgeInverseSim3ProjectXYZ> {
  static Vector2 error(const EdgeInverseSim3ProjectXYZ& e) {
    return e.measurement() -
           second_camera(*e.vertexXn<1>()).image<2>(estimate<1>(e).inverse().map(estimate<0>(e)));
  }
  // A step δ of S changes the point in the camera to S⁻¹ exp(−δ) p.
  static void linearize(EdgeInverseSim3ProjectXYZ& e) {
    const VertexSim3Expmap& v = *e.vertexXn<1>();
    const Sim3 inverse = v.estimate().inverse();
    const Vector3& point = estimate<0>(e);
    Eigen::Matrix<double, 2, 3> D;  // of the image, by the point
    adapters::ImageDerivatives<2>(second_camera(v), inverse.map(point))
        .by_rotated_point(inverse.scale() * inverse.rotation().toRotationMatrix(), D);
    e.jacobianOplusXn<0>() = -D;
    e.jacobianOplusXn<1>() << -D * skew(point), D, D * point;
    if (v._fix_scale) e.jacobianOplusXn<1>().col(6).setZero();
  }
};

template struct EdgeFunctions<EdgeSim3ProjectXYZ>;
template struct EdgeFunctions<EdgeInverseSim3ProjectXYZ>;

}  // namespace internal

EdgeSim3ProjectXYZ::EdgeSim3ProjectXYZ() = default;
EdgeInverseSim3ProjectXYZ::EdgeInverseSim3ProjectXYZ() = default;

namespace {

const internal::EvaluatedInRuns<EdgeSim3ProjectXYZ> kRunsOfSim3ProjectXYZ;
const internal::EvaluatedInRuns<EdgeInverseSim3ProjectXYZ> kRunsOfInverseSim3ProjectXYZ;

}  // namespace

}  // namespace g2o
