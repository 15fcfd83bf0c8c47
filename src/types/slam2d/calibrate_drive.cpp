// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d/calibrate_drive.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstddef>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// Parameters count as undetermined if a Gram matrix with unit diagonal has an eigenvalue below this limit.
constexpr double kSingular = 1e-12;

void check_finite(std::span<const DriveMotion> motions) {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& [wheels, sensor] = motions[i];
    if (!std::isfinite(wheels.left + wheels.right + wheels.duration) || !sensor.vector().allFinite())
      throw InvalidArgument(fmt::format("calibrate_drive: expected finite numbers in motion {}", i));
  }
}

/// Returns G⁻¹B for a Gram matrix G, or nothing if G is singular.
template <int N, int Columns>
std::optional<Eigen::Matrix<double, N, Columns>> solve_gram(const Eigen::Matrix<double, N, N>& gram,
                                                            const Eigen::Matrix<double, N, Columns>& B) {
  if (!(gram.diagonal().minCoeff() > 0)) return {};
  const Eigen::Matrix<double, N, 1> scale = gram.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> unit(scale.asDiagonal() * gram *
                                                                        scale.asDiagonal());
  if (!(unit.eigenvalues()[0] > kSingular)) return {};
  return scale.asDiagonal() *
         (unit.eigenvectors() * unit.eigenvalues().cwiseInverse().asDiagonal() *
          unit.eigenvectors().transpose()) *
         scale.asDiagonal() * B;
}

/// Fits θ = J · (v_l dt, v_r dt) to the rotations θ of the sensor. J = (−k_l, k_r) / baseline.
std::optional<Eigen::Vector2d> fit_rotations(std::span<const DriveMotion> motions) {
  Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rhs = Eigen::Vector2d::Zero();
  for (const auto& [wheels, sensor] : motions) {
    const Eigen::Vector2d driven = wheels.duration * Eigen::Vector2d(wheels.left, wheels.right);
    gram += driven * driven.transpose();
    rhs += driven * sensor.theta();
  }
  return solve_gram(gram, rhs);
}

/// The motion q of the robot and the motion s of the sensor meet at the mount m: t_q + R_q t_m = t_m + R_m
/// t_s. The translation t_q is the baseline times that of a drive with baseline 1. So
///
///     A · (baseline, x_m, y_m) + B · (cos θ_m, sin θ_m) = 0.
///
/// For any heading the first three unknowns minimize |A a + B h|², which becomes hᵀ S h with the Schur
/// complement S = BᵀB − BᵀA (AᵀA)⁻¹ AᵀB. Its smallest value on |h| = 1 is at an eigenvector of S; of the two
/// directions, one has a positive baseline.
std::optional<DriveCalibration> fit_translations(std::span<const DriveMotion> motions,
                                                 const Eigen::Vector2d& J) {
  const DifferentialDrive unit{-J[0], J[1], 1};
  Eigen::Matrix3d AtA = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> AtB = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d BtB = Eigen::Matrix2d::Zero();
  for (const auto& [wheels, sensor] : motions) {
    const SE2 q = WheelOdometry(wheels).motion(unit);
    Eigen::Matrix<double, 2, 3> A;
    A << q.x(), q.cos_theta() - 1, -q.sin_theta(), q.y(), q.sin_theta(), q.cos_theta() - 1;
    Eigen::Matrix2d B;
    B << -sensor.x(), sensor.y(), -sensor.y(), -sensor.x();
    AtA += A.transpose() * A;
    AtB += A.transpose() * B;
    BtB += B.transpose() * B;
  }
  const auto back = solve_gram(AtA, AtB);
  if (!back) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> S(BtB - AtB.transpose() * *back);
  if (!(S.eigenvalues()[1] - S.eigenvalues()[0] > kSingular * BtB.trace())) return {};
  Eigen::Vector2d heading = S.eigenvectors().col(0);
  Eigen::Vector3d a = -*back * heading;
  if (a[0] < 0) {
    heading = -heading;
    a = -a;
  }
  if (!(a[0] > 0)) return {};
  return DriveCalibration{{-J[0] * a[0], J[1] * a[0], a[0]},
                          SE2(a[1], a[2], std::atan2(heading[1], heading[0]))};
}

}  // namespace

std::optional<DriveCalibration> calibrate_drive(std::span<const DriveMotion> motions) {
  check_finite(motions);
  const auto J = fit_rotations(motions);
  return J ? fit_translations(motions, *J) : std::nullopt;
}

WheelSpeeds wheel_speeds(const SE2& motion, double duration, const DifferentialDrive& drive) {
  if (!(duration > 0))
    throw InvalidArgument(fmt::format("wheel_speeds: expected a duration > 0, got {}", duration));
  const double half = motion.theta() / 2;
  const double chord = motion.x() * std::cos(half) + motion.y() * std::sin(half);
  const double arc = half == 0 ? chord : chord * half / std::sin(half);
  const double turn = half * drive.baseline;
  return {(arc - turn) / (drive.left_factor * duration), (arc + turn) / (drive.right_factor * duration),
          duration};
}

}  // namespace boxplus
