// SPDX-License-Identifier: BSD-3-Clause
// The motion that an IMU measured between two times (types/inertial/preintegration.h).
//
// In the body frame at i, let a = R_iᵀ (v_j − v_i − g Δt), s = R_iᵀ (p_j − p_i − v_i Δt − ½ g Δt²), and r the
// error of the rotation. A step of a pose moves it by R Δt and turns it by Exp(φ) in its own frame. With β
// for the change of the biases from motion.bias, and M_r, M_v, M_p for the rows of motion.bias_jacobian, of
// which M_g is the part of M_r for the gyroscope:
//   ∂r/∂φ_i = −J_r(r)⁻¹ R_jᵀ R_i   ∂r/∂φ_j = J_r(r)⁻¹   ∂r/∂b_g = −J_l(r)⁻¹ J_r(M_g β_g) M_g
//   ∂a/∂φ_i = [a]×   ∂a/∂v_i = −R_iᵀ   ∂a/∂v_j = R_iᵀ   ∂(a − Δv)/∂b = −M_v
//   ∂s/∂φ_i = [s]×   ∂s/∂t_i = −I   ∂s/∂v_i = −R_iᵀ Δt   ∂s/∂t_j = R_iᵀ R_j   ∂(s − Δp)/∂b = −M_p
// (Forster et al. 2017, appendix C; J_r(r)⁻¹ Exp(r)ᵀ = J_l(r)⁻¹).
#pragma once

#include "boxplus/manifold/s2.h"
#include "boxplus/types/inertial/preintegration.h"
#include "boxplus/types/inertial/rotation_jacobians.h"

namespace boxplus {

/// The acceleration of a falling body (m/s²).
inline constexpr double kStandardGravity = 9.80665;

/// Error (15 rows, rad, m/s, m, rad/s, m/s²):
///   Log(ΔRᵀ R_iᵀ R_j)
///   R_iᵀ (v_j − v_i − g Δt) − Δv
///   R_iᵀ (p_j − p_i − v_i Δt − ½ g Δt²) − Δp
///   b_j − b_i
/// ΔR, Δv and Δp depend on the biases b_i to first order; if these are far from motion.bias, integrate again.
/// The Ω is Preintegration::information(). Vertices: the pose (SE3 or SE3RotationVector, T_world_body),
/// velocity (Vector3, m/s, in the world) and biases (ImuBias) at i, and then the same at j. A seventh vertex
/// (S2) is the direction in which a body falls, if it is unknown; then only the norm of `gravity` is used.
struct InertialBetween {
  static constexpr std::string_view kName = "InertialBetween";
  InertialMotion motion;
  Vector3 gravity;  ///< g: the acceleration of a falling body (m/s², in the world)

  /// In the world of the default gravity, the z axis points up.
  explicit InertialBetween(const InertialMotion& z, const Vector3& g = Vector3(0, 0, -kStandardGravity))
      : motion(z), gravity(g), gravity_norm_(g.norm()) {}

  template <class S, class Chart>
  Vector<S, 15> error(const BasicSE3<S, Chart>& pose_i, const Vector<S, 3>& velocity_i,
                      const Vector<S, 6>& bias_i, const BasicSE3<S, Chart>& pose_j,
                      const Vector<S, 3>& velocity_j, const Vector<S, 6>& bias_j) const {
    const Vector<S, 3> g = gravity.template cast<S>();
    return error_for(g, pose_i, velocity_i, bias_i, pose_j, velocity_j, bias_j);
  }
  template <class S, class Chart>
  Vector<S, 15> error(const BasicSE3<S, Chart>& pose_i, const Vector<S, 3>& velocity_i,
                      const Vector<S, 6>& bias_i, const BasicSE3<S, Chart>& pose_j,
                      const Vector<S, 3>& velocity_j, const Vector<S, 6>& bias_j,
                      const BasicS2<S>& down) const {
    const Vector<S, 3> g = down.vector() * S(gravity_norm_);
    return error_for(g, pose_i, velocity_i, bias_i, pose_j, velocity_j, bias_j);
  }

  template <class Chart, class A, class B, class C, class D, class E, class F>
  void jacobians(const BasicSE3<double, Chart>& pose_i, const Vector3& velocity_i, const ImuBias& bias_i,
                 const BasicSE3<double, Chart>& pose_j, const Vector3& velocity_j, const ImuBias& /*bias_j*/,
                 A& J_pose_i, B& J_velocity_i, C& J_bias_i, D& J_pose_j, E& J_velocity_j, F& J_bias_j) const {
    jacobians_for(gravity, pose_i, velocity_i, bias_i, pose_j, velocity_j, J_pose_i, J_velocity_i, J_bias_i,
                  J_pose_j, J_velocity_j, J_bias_j);
  }
  template <class Chart, class A, class B, class C, class D, class E, class F, class G>
  void jacobians(const BasicSE3<double, Chart>& pose_i, const Vector3& velocity_i, const ImuBias& bias_i,
                 const BasicSE3<double, Chart>& pose_j, const Vector3& velocity_j, const ImuBias& /*bias_j*/,
                 const S2& down, A& J_pose_i, B& J_velocity_i, C& J_bias_i, D& J_pose_j, E& J_velocity_j,
                 F& J_bias_j, G& J_down) const {
    jacobians_for(Vector3(gravity_norm_ * down.vector()), pose_i, velocity_i, bias_i, pose_j, velocity_j,
                  J_pose_i, J_velocity_i, J_bias_i, J_pose_j, J_velocity_j, J_bias_j);
    const double t = motion.seconds;
    const Matrix<double, 3, 2> fall =
        -gravity_norm_ * t * (pose_i.rotation().transpose() * down.tangent_basis());
    J_down.setZero();
    J_down.template middleRows<3>(3) = fall;
    J_down.template middleRows<3>(6) = 0.5 * t * fall;
  }

 private:
  /// Radians per unit of the rotational part of the step: the quaternion chart has half angles.
  template <class Chart>
  static constexpr double kAngle = std::is_same_v<Chart, detail::QuaternionChart> ? 2 : 1;

  template <class S, class Chart>
  Vector<S, 15> error_for(const Vector<S, 3>& g, const BasicSE3<S, Chart>& pose_i,
                          const Vector<S, 3>& velocity_i, const Vector<S, 6>& bias_i,
                          const BasicSE3<S, Chart>& pose_j, const Vector<S, 3>& velocity_j,
                          const Vector<S, 6>& bias_j) const {
    const double t = motion.seconds;
    const auto z = motion.corrected(bias_i);
    const detail::Quaternion<S> back = pose_i.quaternion().conjugate();
    const Vector<S, 3> v = velocity_j - velocity_i - g * t;
    const Vector<S, 3> p = pose_j.translation() - pose_i.translation() - (velocity_i + g * (0.5 * t)) * t;
    Vector<S, 15> e;
    e.template head<3>() =
        detail::RotationVectorChart::log(z.rotation.conjugate() * (back * pose_j.quaternion()));
    e.template segment<3>(3) = detail::rotate(back, v[0], v[1], v[2]) - z.velocity;
    e.template segment<3>(6) = detail::rotate(back, p[0], p[1], p[2]) - z.position;
    e.template tail<6>() = bias_j - bias_i;
    return e;
  }

  template <class Chart, class A, class B, class C, class D, class E, class F>
  void jacobians_for(const Vector3& g, const BasicSE3<double, Chart>& pose_i, const Vector3& velocity_i,
                     const ImuBias& bias_i, const BasicSE3<double, Chart>& pose_j, const Vector3& velocity_j,
                     A& J_pose_i, B& J_velocity_i, C& J_bias_i, D& J_pose_j, E& J_velocity_j,
                     F& J_bias_j) const {
    const double t = motion.seconds;
    const Matrix<double, 3, 3> RiT = pose_i.rotation().transpose(), R_ij = RiT * pose_j.rotation();
    const Vector3 a = RiT * (velocity_j - velocity_i - t * g);
    const Vector3 s = RiT * (pose_j.translation() - pose_i.translation() - t * (velocity_i + 0.5 * t * g));
    const Matrix<double, 3, 3> M_g = motion.bias_jacobian.topLeftCorner<3, 3>();
    const Vector3 turn = M_g * (bias_i - motion.bias).head<3>();
    const detail::Quaternion<double> z =
        motion.rotation * detail::RotationVectorChart::exp(turn[0], turn[1], turn[2]);
    const Matrix<double, 3, 3> J = detail::inverse_right_jacobian(detail::RotationVectorChart::log(
        z.conjugate() * (pose_i.quaternion().conjugate() * pose_j.quaternion())));

    J_pose_i.setZero();
    J_pose_i.template block<3, 3>(0, 3) = -kAngle<Chart> * J * R_ij.transpose();
    J_pose_i.template block<3, 3>(3, 3) = kAngle<Chart> * detail::cross_matrix(a[0], a[1], a[2]);
    J_pose_i.template block<3, 3>(6, 0) = -Matrix<double, 3, 3>::Identity();
    J_pose_i.template block<3, 3>(6, 3) = kAngle<Chart> * detail::cross_matrix(s[0], s[1], s[2]);
    J_velocity_i.setZero();
    J_velocity_i.template middleRows<3>(3) = -RiT;
    J_velocity_i.template middleRows<3>(6) = -t * RiT;
    J_bias_i.template topLeftCorner<3, 3>() = -J.transpose() * (detail::right_jacobian(turn) * M_g);
    J_bias_i.template topRightCorner<3, 3>().setZero();
    J_bias_i.template middleRows<6>(3) = -motion.bias_jacobian.bottomRows<6>();
    J_bias_i.template bottomRows<6>() = -Matrix<double, 6, 6>::Identity();
    J_pose_j.setZero();
    J_pose_j.template block<3, 3>(0, 3) = kAngle<Chart> * J;
    J_pose_j.template block<3, 3>(6, 0) = R_ij;
    J_velocity_j.setZero();
    J_velocity_j.template middleRows<3>(3) = RiT;
    J_bias_j.setZero();
    J_bias_j.template bottomRows<6>().setIdentity();
  }

  double gravity_norm_;
};

}  // namespace boxplus
