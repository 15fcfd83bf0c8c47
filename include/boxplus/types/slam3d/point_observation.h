// SPDX-License-Identifier: BSD-3-Clause
// A point in space, seen from a pose, with or without a sensor offset.
//
// Let b = X⁻¹ l be the point in the body frame. X ⊞ (Δt, u) moves b to b − Δt − 2 u × b = b − Δt + 2 [b]× u,
// because the quaternion (u, 1) turns by about 2u. In the same way, P ⊞ δ moves p = P⁻¹ b for the offset P:
//   ∂b/∂X = [ −I  2 [b]× ]    ∂p/∂X = R_Pᵀ ∂b/∂X    ∂p/∂P = [ −I  2 [p]× ]    ∂p/∂l = R_Pᵀ R_Xᵀ
#pragma once

#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam3d/between_jacobians.h"

namespace boxplus {

/// z measures the point l in the frame of the pose X (meters). Error: X⁻¹ l − z.
struct PointObservation3 {
  static constexpr std::string_view kName = "PointObservation3";
  static constexpr bool kRigid = true;
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector3 measurement;

  explicit PointObservation3(const Vector3& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const Point& point) const {
    return pose.inverse_times(point) - measurement;
  }

  template <class A, class B>
  void jacobians(const SE3& pose, const Vector3& point, A& J_pose, B& J_point) const {
    const Vector3 b = pose.inverse_times(point);
    J_pose << -Matrix<double, 3, 3>::Identity(), 2 * detail::cross_matrix(b[0], b[1], b[2]);
    J_point = pose.rotation().transpose();
  }

  template <class Pose, class Point>
  detail::RelativeFrame relative_frame(const Pose&, const Point&) const {
    return detail::relative_pose(0, 1, measurement);
  }
};

/// z measures the point l in the frame of a sensor at P on the body. Error: (X P)⁻¹ l − z. Vertices: X, l, P.
/// The tag in g2o files is EDGE_SE3_TRACKXYZ.
struct OffsetPointObservation3 {
  static constexpr std::string_view kName = "OffsetPointObservation3";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector3 measurement;

  explicit OffsetPointObservation3(const Vector3& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const Point& point,
                     const BasicSE3<S, Chart>& offset) const {
    return offset.inverse_times(pose.inverse_times(point)) - measurement;
  }

  template <class A, class B, class C>
  void jacobians(const SE3& pose, const Vector3& point, const SE3& offset, A& J_pose, B& J_point,
                 C& J_offset) const {
    const Vector3 b = pose.inverse_times(point), p = offset.inverse_times(b);
    const Matrix<double, 3, 3> RpT = offset.rotation().transpose();
    J_pose.template leftCols<3>() = -RpT;
    J_pose.template rightCols<3>() = 2 * RpT * detail::cross_matrix(b[0], b[1], b[2]);
    J_point = RpT * pose.rotation().transpose();
    J_offset << -Matrix<double, 3, 3>::Identity(), 2 * detail::cross_matrix(p[0], p[1], p[2]);
  }

  template <class Pose, class Point>
  detail::RelativeFrame relative_frame(const Pose&, const Point&, const Pose& offset) const {
    return detail::relative_pose(0, 1, Vector3(offset * measurement));
  }
};

}  // namespace boxplus
