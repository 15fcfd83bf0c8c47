// SPDX-License-Identifier: BSD-3-Clause
// A point in the plane, seen from a pose, with or without a sensor offset.
//
// Let b = X⁻¹ l be the point in the body frame. X ⊞ δ moves b to R(Δθ)ᵀ (b − Δt) ≈ b − Δt + Δθ (y_b, −x_b).
// In the same way, P ⊞ δ moves p = P⁻¹ b for the offset P:
//   ∂b/∂X = [ −I  (y_b, −x_b)ᵀ ]    ∂p/∂X = R_Pᵀ ∂b/∂X    ∂p/∂P = [ −I  (y_p, −x_p)ᵀ ]    ∂p/∂l = R_Pᵀ R_Xᵀ
#pragma once

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the point l in the frame of the pose X (meters). Error: X⁻¹ l − z. The tag in g2o files is
/// EDGE_SE2_XY.
struct PointObservation2 {
  static constexpr std::string_view kName = "PointObservation2";
  static constexpr bool kRigid = true;
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;

  explicit PointObservation2(const Vector2& z) : measurement(z) {}

  template <class S, class Point>
  Vector<S, 2> error(const BasicSE2<S>& pose, const Point& point) const {
    return pose.inverse_times(point) - measurement;
  }

  template <class A, class B>
  void jacobians(const SE2& pose, const Vector2& point, A& J_pose, B& J_point) const {
    const Vector2 b = pose.inverse_times(point);
    J_pose << -1, 0, b[1], 0, -1, -b[0];
    J_point = pose.rotation().transpose();
  }

  template <class Point>
  detail::RelativeFrame relative_frame(const SE2&, const Point&) const {
    return detail::relative_pose(0, 1, measurement);
  }
};

/// z measures the point l in the frame of a sensor at P on the body. Error: (X P)⁻¹ l − z. Vertices: X, l, P.
/// The tag in g2o files is EDGE_SE2_POINTXY_OFFSET if P is a parameter, and EDGE_SE2_XY_CALIB if P is a
/// vertex.
struct OffsetPointObservation2 {
  static constexpr std::string_view kName = "OffsetPointObservation2";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;

  explicit OffsetPointObservation2(const Vector2& z) : measurement(z) {}

  template <class S, class Point>
  Vector<S, 2> error(const BasicSE2<S>& pose, const Point& point, const BasicSE2<S>& offset) const {
    return offset.inverse_times(pose.inverse_times(point)) - measurement;
  }

  template <class A, class B, class C>
  void jacobians(const SE2& pose, const Vector2& point, const SE2& offset, A& J_pose, B& J_point,
                 C& J_offset) const {
    const Vector2 b = pose.inverse_times(point), p = offset.inverse_times(b);
    const Matrix<double, 2, 2> RpT = offset.rotation().transpose();
    J_pose.template leftCols<2>() = -RpT;
    J_pose.col(2) = RpT * Vector2(b[1], -b[0]);
    J_point = RpT * pose.rotation().transpose();
    J_offset << -1, 0, p[1], 0, -1, -p[0];
  }

  template <class Point>
  detail::RelativeFrame relative_frame(const SE2&, const Point&, const SE2& offset) const {
    return detail::relative_pose(0, 1, Vector2(offset * measurement));
  }
};

}  // namespace boxplus
