// SPDX-License-Identifier: BSD-3-Clause
// Preintegration: many measurements of an IMU become one relative measurement of motion (Forster, Carlone,
// Dellaert & Scaramuzza, "On-Manifold Preintegration for Real-Time Visual-Inertial Odometry", IEEE
// Transactions on Robotics 33(1), 2017). "eq." refers to this paper.
//
// The body frame is the frame of the IMU. Units are meters, seconds and radians.
#pragma once

#include "boxplus/manifold/se3.h"

namespace boxplus {

/// The biases of gyroscope (rad/s) and accelerometer (m/s²), in this order: measurement = truth + bias +
/// noise. A vertex.
using ImuBias = Vector<double, 6>;

/// The noise of an IMU, as densities of white noise in continuous time, as data sheets have them. So a
/// measurement that stands for a time dt has the standard deviation density/√dt, and in this time each bias
/// changes by a random step with the standard deviation walk·√dt. The defaults are typical of a MEMS sensor.
struct ImuNoise {
  double gyroscope = 1.7e-4;         ///< rad/s/√Hz = rad/√s
  double accelerometer = 2e-3;       ///< m/s²/√Hz = m/s/√s
  double gyroscope_walk = 2e-5;      ///< rad/s²/√Hz = rad/s/√s
  double accelerometer_walk = 3e-3;  ///< m/s³/√Hz = m/s²/√s
};

/// Pose and velocity (m/s, in the world) of a body.
template <class S, class Chart = detail::QuaternionChart>
struct BasicInertialState {
  BasicSE3<S, Chart> pose;
  Vector<S, 3> velocity = Vector<S, 3>::Zero();
};
using InertialState = BasicInertialState<double>;

/// The motion that an IMU measured between the times i and j, without gravity and the velocity at i, and with
/// its first-order dependence on the biases (eq. 44):
///   R_j = R_i ΔR,   v_j = v_i + g Δt + R_i Δv,   p_j = p_i + v_i Δt + ½ g Δt² + R_i Δp
struct InertialMotion {
  double seconds = 0;                               ///< Δt
  detail::Quaternion<double> rotation{0, 0, 0, 1};  ///< ΔR at `bias`
  Vector3 velocity{0, 0, 0}, position{0, 0, 0};     ///< Δv and Δp at `bias`, in the frame of the body at i
  ImuBias bias = ImuBias::Zero();                   ///< the biases that were subtracted
  /// The derivatives of (ΔR, Δv, Δp) with respect to the biases. Δ of a rotation is a rotation vector at its
  /// right: ΔR Exp(Δ).
  Matrix<double, 9, 6> bias_jacobian = Matrix<double, 9, 6>::Zero();

  /// ΔR, Δv and Δp for other biases, to first order.
  template <class S>
  struct Corrected {
    detail::Quaternion<S> rotation;
    Vector<S, 3> velocity, position;
  };
  template <class S>
  Corrected<S> corrected(const Vector<S, 6>& other) const {
    const Vector<S, 6> delta = other - bias;
    const Vector<S, 3> turn = bias_jacobian.topLeftCorner<3, 3>() * delta.template head<3>();
    return {rotation * detail::RotationVectorChart::exp(turn[0], turn[1], turn[2]),
            velocity + bias_jacobian.middleRows<3>(3) * delta,
            position + bias_jacobian.bottomRows<3>() * delta};
  }

  /// The state at the time j. `gravity` is the acceleration of a falling body (m/s², in the world).
  template <class Chart>
  BasicInertialState<double, Chart> predict(const BasicSE3<double, Chart>& pose, const Vector3& velocity_i,
                                            const ImuBias& bias_i, const Vector3& gravity) const {
    const Corrected<double> motion = corrected(bias_i);
    const Vector3 v = velocity_i + 0.5 * seconds * gravity;
    return {BasicSE3<double, Chart>(Vector3(pose * motion.position + seconds * v),
                                    pose.quaternion() * motion.rotation),
            velocity_i + seconds * gravity + pose.so3() * motion.velocity};
  }
};

/// Integrates the measurements between two times.
class Preintegration {
 public:
  using Covariance = Matrix<double, 15, 15>;

  /// `bias` is the best guess of the biases. It will be subtracted from the measurements, and is the point at
  /// which the motion is linear in the biases. Throws InvalidArgument if a density is negative, or a number
  /// is not finite.
  explicit Preintegration(const ImuNoise& noise, const ImuBias& bias = ImuBias::Zero());

  /// Adds a measurement: the angular velocity (rad/s) and the specific force (m/s²; at rest it points up,
  /// away from the earth) of the body in its own frame, which are constant for `seconds`. If the IMU samples
  /// at points in time, use the mean of two consecutive samples. Throws InvalidArgument if a number is not
  /// finite, or if `seconds` is not positive.
  ///
  /// The force is rotated by its mean rotation, so the error of a step is of third order in `seconds`. (Eq.
  /// 37 takes the rotation at the beginning, and its error is of second order.)
  void integrate(const Vector3& angular_velocity, const Vector3& specific_force, double seconds);

  const InertialMotion& motion() const { return motion_; }
  int measurements() const { return measurements_; }

  /// The covariance of the error of InertialBetween, in the same order: rotation, velocity, position, change
  /// of the gyroscope's bias, change of the accelerometer's bias. Propagated by each measurement (eq. 63),
  /// with the random walk of the biases within the interval.
  const Covariance& covariance() const { return covariance_; }
  /// The inverse of covariance(), the Ω of InertialBetween. Throws InvalidArgument if the covariance is
  /// singular, as it is for fewer than two measurements, or if a density is zero.
  Covariance information() const;

 private:
  ImuNoise noise_;
  InertialMotion motion_;
  Covariance covariance_ = Covariance::Zero();
  int measurements_ = 0;
};

}  // namespace boxplus
