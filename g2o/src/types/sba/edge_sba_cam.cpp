// SPDX-License-Identifier: BSD-3-Clause
// Edges between two cameras.
#include "g2o/types/sba/edge_sba_cam.h"

#include "g2o/types/sba/edge_sba_scale.h"
#include "types/ready_made_edge.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

/// A copy of the camera with another pose.
SBACam moved(const SBACam& cam, const SE3Quat& pose) {
  SBACam result = cam;
  result.setRotation(pose.rotation());
  result.setTranslation(pose.translation());
  return result;
}

}  // namespace

namespace internal {

template <>
struct EdgeModel<EdgeSBACam> {
  using Native = boxplus::Between<boxplus::SE3>;
  // A step changes the translation of a camera in the world frame. For a pose of the engine, a step changes
  // the translation in the body frame. Therefore, the Jacobians for the translations are multiplied by the
  // rotation from the world to the camera.
  static void linearized(EdgeSBACam& e) {
    e.jacobianOplusXn<0>().leftCols<3>() *= estimate<0>(e).w2n.leftCols<3>();
    e.jacobianOplusXn<1>().leftCols<3>() *= estimate<1>(e).w2n.leftCols<3>();
  }
  static SE3Quat measured(const EdgeSBACam& e) { return estimate<0>(e).inverse() * estimate<1>(e); }
  static SBACam first(const EdgeSBACam& e) {
    return moved(estimate<0>(e), estimate<1>(e) * e.measurement().inverse());
  }
  static SBACam second(const EdgeSBACam& e) {
    return moved(estimate<1>(e), estimate<0>(e) * e.measurement());
  }
};

template <>
struct EdgeModel<EdgeSBAScale> {
  static Vector3 difference(const EdgeSBAScale& e) {
    return estimate<1>(e).translation() - estimate<0>(e).translation();
  }
  static double measured(const EdgeSBAScale& e) { return difference(e).norm(); }
  static double error(const EdgeSBAScale& e) { return e.measurement() - measured(e); }
  static void linearize(EdgeSBAScale& e) {
    auto &Xi = e.jacobianOplusXn<0>(), &Xj = e.jacobianOplusXn<1>();
    Xi.setZero();
    Xi.leftCols<3>() = difference(e).stableNormalized().transpose();
    Xj = -Xi;
  }
  static SBACam first(const EdgeSBAScale& e) { return at_distance(estimate<0>(e), estimate<1>(e), e); }
  static SBACam second(const EdgeSBAScale& e) { return at_distance(estimate<1>(e), estimate<0>(e), e); }

 private:
  static SBACam at_distance(SBACam cam, const SBACam& known, const EdgeSBAScale& e) {
    const Vector3 direction = (cam.translation() - known.translation()).stableNormalized();
    cam.setTranslation(known.translation() + e.measurement() * direction);
    return cam;
  }
};

template struct EdgeFunctions<EdgeSBACam>;
template struct EdgeFunctions<EdgeSBAScale>;

}  // namespace internal

EdgeSBACam::EdgeSBACam() = default;
EdgeSBAScale::EdgeSBAScale() = default;

}  // namespace g2o
