// SPDX-License-Identifier: BSD-3-Clause
// Two matching points of the surfaces that two poses see (Segal, Haehnel and Thrun, "Generalized-ICP", 2009).
//
// Let b = x₀⁻¹ x₁ p₁ be the second point in the frame of the first pose, and R the rotation of x₀⁻¹ x₁. In
// the tangent of SE3:
//   ∂b/∂x₀ = [ −I  2 [b]× ]    ∂b/∂x₁ = R [ I  −2 [p₁]× ]
#pragma once

#include <string_view>

#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam3d/between_jacobians.h"

namespace boxplus {

namespace detail {

/// The matrix with the rows n × a, a and n for a normal n, which is not normalized. a is the unit vector that
/// is orthogonal to n and closest to the y axis, or to the x axis if n is parallel to the y axis (within
/// 1e-3 rad, so that a has 13 correct digits).
Matrix<double, 3, 3> frame_of_normal(const Vector3& normal);

}  // namespace detail

/// A point p₀ with its normal n₀ in the frame of x₀, and the matching point p₁ with n₁ in the frame of x₁
/// (meters). Error: x₀⁻¹ x₁ p₁ − p₀. Vertices: x₀, x₁. The tag in g2o files is EDGE_V_V_GICP. Its lines have
/// no Ω, because Ω follows from n₀: information().
struct SurfaceMatch {
  static constexpr std::string_view kName = "SurfaceMatch";
  static constexpr bool kJacobiansForSomeTypes = true;
  /// The information in the directions of the surface. Along the normal, it is 1.
  static constexpr double kAcross = 0.01;

  Vector3 measurement;                            ///< p₀
  Vector3 normal = Vector3(0, 0, 1);              ///< n₀
  Vector3 other_point, other_normal = {0, 0, 1};  ///< p₁ and n₁, which is kept for files only

  SurfaceMatch(const Vector3& p0, const Vector3& n0, const Vector3& p1, const Vector3& n1)
      : measurement(p0), normal(n0), other_point(p1), other_normal(n1) {}

  template <class S, class Chart>
  Vector<S, 3> error(const BasicSE3<S, Chart>& x0, const BasicSE3<S, Chart>& x1) const {
    return x0.inverse_times(x1 * other_point) - measurement;
  }

  template <class A, class B>
  void jacobians(const SE3& x0, const SE3& x1, A& J_x0, B& J_x1) const {
    const Vector3 b = x0.inverse_times(x1 * other_point);
    const Vector3& p = other_point;
    const Matrix<double, 3, 3> R = x0.rotation().transpose() * x1.rotation();
    J_x0 << -Matrix<double, 3, 3>::Identity(), 2 * detail::cross_matrix(b[0], b[1], b[2]);
    J_x1 << R, -2 * R * detail::cross_matrix(p[0], p[1], p[2]);
  }

  /// Ω for a surface with the normal n₀, which must not be zero: Fᵀ diag(kAcross, kAcross, 1) F with F =
  /// frame_of_normal(n₀/|n₀|).
  Matrix<double, 3, 3> information() const {
    const Matrix<double, 3, 3> F = detail::frame_of_normal(normal / normal.norm());
    const Matrix<double, 3, 3> omega = F.transpose() * Vector3(kAcross, kAcross, 1).asDiagonal() * F;
    return 0.5 * (omega + omega.transpose());
  }
};

}  // namespace boxplus
