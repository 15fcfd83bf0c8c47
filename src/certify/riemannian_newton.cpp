// SPDX-License-Identifier: BSD-3-Clause
#include "certify/riemannian_newton.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "boxplus/base/progress.h"
#include "guess/nearest_rotation.h"

namespace boxplus::certificate {
namespace {

constexpr double kFirstLambda = 1e-4, kLeastLambda = 1e-7, kMostLambda = 1e9;

/// The tangent size of a stacked pose: skew-symmetric matrices, directions out of the row space, positions.
std::uint32_t tangent_size(int d, int rank) {
  return static_cast<std::uint32_t>(d * (d - 1) / 2 + d * (rank - d) + rank);
}

/// A basis of the tangent space at X. Each column holds the entries of a (d + 1) × p matrix.
Eigen::MatrixXd tangent_basis(const StackedPose& pose, int d) {
  const Eigen::Index rank = pose.cols();
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero((d + 1) * rank, tangent_size(d, static_cast<int>(rank)));
  Eigen::Index column = 0;
  const auto next = [&] { return Eigen::Map<Eigen::MatrixXd>(basis.col(column++).data(), d + 1, rank); };
  for (int i = 0; i < d; ++i) {
    for (int j = 0; j < i; ++j) {
      auto e = next();
      e.row(i) = pose.row(j);
      e.row(j) = -pose.row(i);
    }
  }
  if (rank > d) {
    const Eigen::MatrixXd rows = pose.topRows(d).transpose();
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(rows).householderQ();
    for (Eigen::Index l = d; l < rank; ++l) {
      for (int i = 0; i < d; ++i) next().row(i) = q.col(l).transpose();
    }
  }
  for (Eigen::Index l = 0; l < rank; ++l) next()(d, l) = 1;
  return basis;
}

}  // namespace

void orthonormalize(StackedPose& pose) {
  const Eigen::Index d = pose.rows() - 1;
  if (pose.cols() == d) {
    const guess::SmallMatrix rows = pose.topRows(d);
    if (const auto rotation = guess::nearest_rotation(rows)) pose.topRows(d) = *rotation;
    return;
  }
  const Eigen::MatrixXd rows = pose.topRows(d);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
  pose.topRows(d) = svd.matrixU() * svd.matrixV().transpose();
}

RiemannianNewton::RiemannianNewton(const ChordalProblem& problem, DualMatrix& dual, int rank,
                                   const Resources& resources)
    : problem_(problem), dual_(dual), resources_(resources), basis_(problem.moving.size()) {
  std::vector<BlockCoordinate> lower;
  const BlockStructure& of_dual = dual.structure();
  for (std::uint32_t j = 0; j < of_dual.blocks(); ++j) {
    for (std::uint32_t k = of_dual.column_start[j] + 1; k < of_dual.column_start[j + 1]; ++k)
      lower.push_back({of_dual.row[k], j});
  }
  structure_ = make_block_structure(
      std::vector<std::uint32_t>(problem.moving.size(), tangent_size(problem.dimension, rank)), lower,
      resources.stop);
  values_.resize(structure_.nonzero_values());
  diagonal_.resize(structure_.scalars());
  gradient_.resize(structure_.scalars());
  factor_.emplace(structure_, values_, 1, resources);
}

void RiemannianNewton::linearize(const StackedPoses& poses) {
  dual_.update(poses);
  const int d = problem_.dimension;
  const Eigen::Index rank = poses.front().cols(), stacked = (d + 1) * rank;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i) {
    const std::uint32_t pose = problem_.moving[i];
    basis_[i] = tangent_basis(poses[pose], d);
    const Eigen::MatrixXd residual = dual_.residual(pose);
    Eigen::Map<Eigen::VectorXd>(gradient_.data() + structure_.offset[i], basis_[i].cols()) =
        basis_[i].transpose() * residual.reshaped();
  }
  Eigen::MatrixXd product(stacked, structure_.blocks() > 0 ? structure_.dim(0) : 0);
  for (std::uint32_t j = 0; j < structure_.blocks(); ++j) {
    const Eigen::Index size = basis_[j].cols();
    for (std::uint32_t k = structure_.column_start[j]; k < structure_.column_start[j + 1]; ++k) {
      Eigen::Map<Eigen::MatrixXd>(product.data(), d + 1, rank * size).noalias() =
          dual_.block(j, k) * Eigen::Map<const Eigen::MatrixXd>(basis_[j].data(), d + 1, rank * size);
      Eigen::Map<Eigen::MatrixXd>(values_.data() + structure_.value_start[k], size, size).noalias() =
          basis_[structure_.row[k]].transpose() * product;
    }
    const double* block = values_.data() + structure_.value_start[structure_.column_start[j]];
    for (Eigen::Index a = 0; a < size; ++a)
      diagonal_[structure_.offset[j] + static_cast<std::size_t>(a)] = std::abs(block[a * (size + 1)]);
  }
}

/// Solves (H + λ D) Δ = −g. Raises λ until the matrix is positive definite.
bool RiemannianNewton::find_step() {
  while (!factor_->factorize({.lambda = lambda_, .diagonal = diagonal_.data()})) {
    lambda_ = std::max(10 * lambda_, kFirstLambda);
    if (!(lambda_ < kMostLambda)) return false;
  }
  step_ = gradient_;
  factor_->solve(step_);
  for (double& value : step_) value = -value;
  return std::all_of(step_.begin(), step_.end(), [](double value) { return std::isfinite(value); });
}

StackedPoses RiemannianNewton::moved(const StackedPoses& poses) const {
  const int d = problem_.dimension;
  StackedPoses result = poses;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i) {
    const Eigen::VectorXd motion =
        basis_[i] * Eigen::Map<const Eigen::VectorXd>(step_.data() + structure_.offset[i], basis_[i].cols());
    StackedPose& pose = result[problem_.moving[i]];
    pose += Eigen::Map<const Eigen::MatrixXd>(motion.data(), d + 1, pose.cols());
    orthonormalize(pose);
  }
  return result;
}

int RiemannianNewton::minimize(StackedPoses& poses, double tolerance, int max_steps) {
  if (structure_.blocks() == 0) return dual_.update(poses), 0;
  double cost = problem_.cost(poses);
  lambda_ = 0;
  int steps = 0;
  for (; steps < max_steps; ++steps) {
    resources_.stop.check();
    if (detail::is_watched())
      detail::note_progress(std::numeric_limits<double>::quiet_NaN(), "step " + std::to_string(steps + 1));
    linearize(poses);
    for (bool accepted = false; !accepted;) {
      if (!find_step()) return dual_.update(poses), steps;
      double decrease = 0;  // that the undamped model predicts, at least
      for (std::size_t i = 0; i < step_.size(); ++i) decrease -= gradient_[i] * step_[i];
      const bool is_last = lambda_ == 0 && decrease <= tolerance * cost;
      StackedPoses trial = moved(poses);
      const double trial_cost = problem_.cost(trial);
      accepted = trial_cost < cost;
      if (accepted) {
        poses = std::move(trial);
        cost = trial_cost;
        lambda_ = lambda_ > kLeastLambda ? lambda_ / 10 : 0;
      }
      if (is_last) return dual_.update(poses), steps + (accepted ? 1 : 0);
      if (!accepted) lambda_ = std::max(10 * lambda_, kFirstLambda);
      if (!(lambda_ < kMostLambda)) return dual_.update(poses), steps;
    }
  }
  dual_.update(poses);
  return steps;
}

}  // namespace boxplus::certificate
