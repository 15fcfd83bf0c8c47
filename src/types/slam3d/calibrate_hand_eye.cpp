// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/calibrate_hand_eye.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// X is not determined if, for unit rotation vectors, a second axis has less than this share of the squares.
constexpr double kLeastShare = 1e-12;

void check_finite(std::span<const HandEye<SE3>> motions) {
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!motions[i].hand.vector().allFinite() || !motions[i].eye.vector().allFinite())
      throw InvalidArgument(fmt::format("calibrate_hand_eye: expected finite numbers in motion {}", i));
  }
}

/// The rotation R that minimizes Σ |α − R β|² for the rotation vectors α of the hand and β of the eye, or
/// nothing if they have only one axis. With two axes, R is determined, because it must not be a reflection.
std::optional<Eigen::Matrix3d> fit_rotation(std::span<const HandEye<SE3>> motions) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& [hand, eye] : motions)
    sum += hand.so3().rotation_vector() * eye.so3().rotation_vector().transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()[1] > kLeastShare * svd.singularValues()[0])) return {};
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// The translation t with R_A t + t_A = R t_B + t, or nothing if it is not determined.
std::optional<Vector3> fit_translation(std::span<const HandEye<SE3>> motions, const Eigen::Matrix3d& R) {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  for (const auto& [hand, eye] : motions) {
    const Eigen::Matrix3d turn = hand.rotation() - Eigen::Matrix3d::Identity();
    gram += turn.transpose() * turn;
    rhs += turn.transpose() * (R * eye.translation() - hand.translation());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gram);
  const Eigen::Vector3d& values = solver.eigenvalues();
  if (!(values[0] > kLeastShare * values[2])) return {};
  return Vector3(solver.eigenvectors() * values.cwiseInverse().asDiagonal() *
                 solver.eigenvectors().transpose() * rhs);
}

}  // namespace

std::optional<SE3> calibrate_hand_eye(std::span<const HandEye<SE3>> motions) {
  check_finite(motions);
  const auto rotation = fit_rotation(motions);
  if (!rotation) return {};
  const auto translation = fit_translation(motions, *rotation);
  if (!translation) return {};
  return SE3(*translation, Matrix<double, 3, 3>(*rotation));
}

}  // namespace boxplus
