// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial/preintegration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "boxplus/base/error.h"
#include "boxplus/types/inertial/rotation_jacobians.h"

namespace boxplus {
namespace {

using Matrix3 = Matrix<double, 3, 3>;

/// The motion during one measurement. If the motion so far changes by x = (rotation, velocity, position), and
/// the measurement by y = (angular velocity, force), the motion after the step changes by F x + G y.
/// Rotations change at their right.
struct Step {
  detail::Quaternion<double> rotation;
  Vector3 velocity, position;  ///< in the frame of the body before the step
  Matrix<double, 9, 9> F;
  Matrix<double, 9, 6> G;
};

/// The mean of Exp(uφ) over the step is Exp(φ/2) but for terms of second order in φ. The position is a double
/// integral, for which the mean has the weight 2(1 − u) and is Exp(φ/3).
Step step_of(const Matrix3& R, const Vector3& omega, const Vector3& force, double dt) {
  const Vector3 phi = dt * omega, half = 0.5 * phi, third = phi / 3;
  const Matrix3 mean = SO3::from_rotation_vector(half).rotation(),
                early_mean = SO3::from_rotation_vector(third).rotation();
  const Matrix3 force_cross = detail::cross_matrix(force[0], force[1], force[2]);
  Step step;
  step.rotation = SO3::from_rotation_vector(phi).quaternion();
  step.velocity = dt * (mean * force);
  step.position = 0.5 * dt * dt * (early_mean * force);
  const Vector3 &v = step.velocity, &p = step.position;

  step.F.setIdentity();
  step.F.block<3, 3>(0, 0) = detail::rotation_matrix(step.rotation).transpose();
  step.F.block<3, 3>(3, 0) = -R * detail::cross_matrix(v[0], v[1], v[2]);
  step.F.block<3, 3>(6, 0) = -R * detail::cross_matrix(p[0], p[1], p[2]);
  step.F.block<3, 3>(6, 3) = dt * Matrix3::Identity();
  step.G.setZero();
  step.G.block<3, 3>(0, 0) = dt * detail::right_jacobian(phi);
  step.G.block<3, 3>(3, 0) = -dt * dt / 2 * (R * mean * force_cross * detail::right_jacobian(half));
  step.G.block<3, 3>(3, 3) = dt * (R * mean);
  step.G.block<3, 3>(6, 0) =
      -dt * dt * dt / 6 * (R * early_mean * force_cross * detail::right_jacobian(third));
  step.G.block<3, 3>(6, 3) = dt * dt / 2 * (R * early_mean);
  return step;
}

void require_finite(bool is_finite, const char* what) {
  if (!is_finite)
    throw InvalidArgument(std::string("Preintegration: expected finite numbers, got a ") + what +
                          " that is not finite");
}

}  // namespace

Preintegration::Preintegration(const ImuNoise& noise, const ImuBias& bias) : noise_(noise) {
  for (const double density :
       {noise.gyroscope, noise.accelerometer, noise.gyroscope_walk, noise.accelerometer_walk}) {
    require_finite(std::isfinite(density), "density of the noise");
    if (density < 0)
      throw InvalidArgument("Preintegration: expected densities of noise that are not negative, got " +
                            std::to_string(density));
  }
  require_finite(bias.allFinite(), "bias");
  motion_.bias = bias;
}

void Preintegration::integrate(const Vector3& angular_velocity, const Vector3& specific_force,
                               double seconds) {
  require_finite(angular_velocity.allFinite(), "angular velocity");
  require_finite(specific_force.allFinite(), "specific force");
  require_finite(std::isfinite(seconds), "duration");
  if (seconds <= 0)
    throw InvalidArgument("Preintegration: expected a positive duration of a measurement, got " +
                          std::to_string(seconds) + " s");

  const Matrix3 R = detail::rotation_matrix(motion_.rotation);
  const Step step =
      step_of(R, angular_velocity - motion_.bias.head<3>(), specific_force - motion_.bias.tail<3>(), seconds);
  motion_.position += seconds * motion_.velocity + R * step.position;
  motion_.velocity += R * step.velocity;
  motion_.rotation = detail::renormalized(motion_.rotation * step.rotation);
  motion_.seconds += seconds;
  motion_.bias_jacobian = step.F * motion_.bias_jacobian - step.G;
  ++measurements_;

  // The error is the truth minus what was measured. The biases have changed by β since the beginning, which
  // was not subtracted. So y = −β − n for the noise n.
  auto motion = covariance_.topLeftCorner<9, 9>();
  auto biases = covariance_.bottomRightCorner<6, 6>();
  auto mixed = covariance_.topRightCorner<9, 6>();
  Vector<double, 6> noise, walk;
  noise << Vector3::Constant(noise_.gyroscope), Vector3::Constant(noise_.accelerometer);
  walk << Vector3::Constant(noise_.gyroscope_walk), Vector3::Constant(noise_.accelerometer_walk);
  noise = noise.cwiseAbs2() / seconds;
  walk = walk.cwiseAbs2() * seconds;
  const Matrix<double, 9, 9> moved = step.F * motion - step.G * mixed.transpose();
  const Matrix<double, 9, 6> new_mixed = step.F * mixed - step.G * biases;
  motion = moved * step.F.transpose() - new_mixed * step.G.transpose() +
           step.G * noise.asDiagonal() * step.G.transpose();
  mixed = new_mixed;
  covariance_.bottomLeftCorner<6, 9>() = mixed.transpose();
  biases.diagonal() += walk;
}

Preintegration::Covariance Preintegration::information() const {
  // The correlations, which do not depend on the units, show whether the covariance is singular.
  constexpr double kSingular = 1e-12;
  const Vector<double, 15> scale = covariance_.diagonal().cwiseSqrt();
  if ((scale.array() > 0).all()) {
    const Vector<double, 15> inverse_scale = scale.cwiseInverse();
    const Covariance correlation = inverse_scale.asDiagonal() * covariance_ * inverse_scale.asDiagonal();
    const Eigen::LDLT<Eigen::Matrix<double, 15, 15>> factor(correlation);
    if (factor.info() == Eigen::Success && factor.vectorD().minCoeff() > kSingular) {
      const Covariance inverse = inverse_scale.asDiagonal() *
                                 Covariance(factor.solve(Covariance::Identity())) *
                                 inverse_scale.asDiagonal();
      return 0.5 * (inverse + inverse.transpose());
    }
  }
  throw InvalidArgument(
      "Preintegration: expected at least two measurements and positive densities of the noise, so that the "
      "covariance is not singular; got " +
      std::to_string(measurements_) + " measurements");
}

}  // namespace boxplus
