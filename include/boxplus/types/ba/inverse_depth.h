// SPDX-License-Identifier: BSD-3-Clause
// Points in the inverse depth parameterization (Civera, Davison and Montiel, "Inverse depth parametrization
// for monocular SLAM", 2008), anchored in the frame of a camera.
//
// Let p be a point in the frame of its anchor A, ψ = (p_x/p_z, p_y/p_z, 1/p_z), u = (ψ₀, ψ₁, 1) and
// (R, t) = X⁻¹ A. The point in the frame of the camera X is R p + t. The image depends only on its direction,
// so it is the image of h = R u + ψ₂ t, which is also defined for points at infinity (ψ₂ = 0).
//   ∂h/∂ψ = [ R₀  R₁  t ]    ∂h/∂X = [ −ψ₂ I  [h]× ]    ∂h/∂A = R [ ψ₂ I  −[u]× ]
// with the first columns R₀, R₁ of R, in the tangent of SE3RotationVector.
#pragma once

#include <string_view>

#include "boxplus/types/ba/image.h"

namespace boxplus {

/// z measures the pixel of the point ψ of the anchor A in the camera X. Error: image − z, in pixels.
/// Vertices: ψ, X, A, StereoCamera. The tag in files is EDGE_PROJECT_PSI2UV:EXPMAP; its poses are
/// SE3RotationVector.
struct InverseDepthImage {
  static constexpr std::string_view kName = "InverseDepthImage";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;

  explicit InverseDepthImage(const Vector2& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, 2> error(const Point& psi, const BasicSE3<S, Chart>& pose, const BasicSE3<S, Chart>& anchor,
                     const BasicStereoCamera<S>& camera) const {
    return camera.pinhole().template image<2>(direction(psi, pose.inverse_times(anchor))) - measurement;
  }

  template <class Chart, class A, class B, class C, class D>
  void jacobians(const Vector3& psi, const BasicSE3<double, Chart>& pose,
                 const BasicSE3<double, Chart>& anchor, const StereoCamera& camera, A& J_psi, B& J_pose,
                 C& J_anchor, D& J_camera) const {
    const BasicSE3<double, Chart> motion = pose.inverse_times(anchor);
    const Vector3 h = direction(psi, motion);
    const detail::ImageDerivatives<2> by(camera.pinhole(), h);
    const Matrix<double, 2, 3> J = by.by_point();
    const Matrix<double, 2, 5> J_parameters = by.by_parameters();
    const Matrix<double, 2, 3> JR = J * motion.rotation();
    constexpr double kUnit = detail::kAngleUnit<Chart>;
    J_psi << JR.template leftCols<2>(), J * motion.translation();
    J_pose << -psi[2] * J, kUnit * J * detail::cross_matrix(h[0], h[1], h[2]);
    J_anchor << psi[2] * JR, -kUnit * JR * detail::cross_matrix(psi[0], psi[1], 1);
    J_camera.col(0) = J_parameters.col(0) + J_parameters.col(1);
    J_camera.template middleCols<2>(1) = J_parameters.template middleCols<2>(2);
    J_camera.col(3).setZero();
  }

 private:
  /// h.
  template <class S, class Chart, class Point>
  static Vector<S, 3> direction(const Point& psi, const BasicSE3<S, Chart>& motion) {
    const Vector<S, 3> Ru = detail::rotate(motion.quaternion(), S(psi[0]), S(psi[1]), S(1.0));
    return Ru + motion.translation() * S(psi[2]);
  }
};

}  // namespace boxplus
