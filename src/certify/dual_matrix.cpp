// SPDX-License-Identifier: BSD-3-Clause
#include "certify/dual_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace boxplus::certificate {
namespace {

using BlockMap = Eigen::Map<Eigen::MatrixXd>;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

DualMatrix::DualMatrix(const ChordalProblem& problem, const Resources& resources) : problem_(problem) {
  const auto d = static_cast<std::uint32_t>(problem.dimension);
  std::vector<BlockCoordinate> lower;
  for (const ChordalEdge& edge : problem.edges) {
    const std::uint32_t i = problem.block[edge.from], j = problem.block[edge.to];
    if (i != ChordalProblem::kPinned && j != ChordalProblem::kPinned)
      lower.push_back({std::max(i, j), std::min(i, j)});
  }
  structure_ =
      make_block_structure(std::vector<std::uint32_t>(problem.moving.size(), d + 1), lower, resources.stop);
  quadratic_.assign(structure_.nonzero_values(), 0);
  add_edges();
  values_ = quadratic_;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i) {
    rotation_rows_.insert(rotation_rows_.end(), d, 1);
    rotation_rows_.push_back(0);
  }
  factor_.emplace(structure_, values_, kMostRank, resources);
}

double* DualMatrix::entry(std::uint32_t row, std::uint32_t column) {
  return quadratic_.data() + structure_.value_start[structure_.find(row, column)];
}

void DualMatrix::add_edges() {
  const int size = problem_.dimension + 1;
  for (const ChordalEdge& edge : problem_.edges) {
    const std::uint32_t i = problem_.block[edge.from], j = problem_.block[edge.to];
    const Block weighted = edge.weight * edge.motion;  // W B
    if (j != ChordalProblem::kPinned) BlockMap(entry(j, j), size, size) += edge.weight;
    if (i != ChordalProblem::kPinned)
      BlockMap(entry(i, i), size, size) += edge.motion.transpose().lazyProduct(weighted);
    if (i == ChordalProblem::kPinned || j == ChordalProblem::kPinned) continue;
    if (j > i) {
      BlockMap(entry(j, i), size, size) -= weighted;
    } else {
      BlockMap(entry(i, j), size, size) -= weighted.transpose();
    }
  }
}

Block DualMatrix::block(std::uint32_t column, std::uint32_t k) const {
  const int size = static_cast<int>(structure_.dim(column));
  return Eigen::Map<const Eigen::MatrixXd>(values_.data() + structure_.value_start[k], size, size);
}

void DualMatrix::update(const StackedPoses& poses) {
  const int d = problem_.dimension;
  values_ = quadratic_;
  residual_ = problem_.gradient(poses);
  magnitudes_.resize(structure_.scalars());
  multipliers_ = 0;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i) {
    const std::uint32_t pose = problem_.moving[i];
    const Block product = residual_[pose].topRows(d) * poses[pose].topRows(d).transpose();
    const Block multiplier = 0.5 * (product + product.transpose());
    residual_[pose].topRows(d) -= multiplier * poses[pose].topRows(d);
    double* diagonal = values_.data() + structure_.value_start[structure_.column_start[i]];
    BlockMap(diagonal, d + 1, d + 1).topLeftCorner(d, d) -= multiplier;
    const double* const quadratic = quadratic_.data() + structure_.value_start[structure_.column_start[i]];
    for (int row = 0; row <= d; ++row) {
      const double of_multiplier = row < d ? multiplier.row(row).cwiseAbs().sum() : 0;
      magnitudes_[structure_.offset[i] + static_cast<std::uint32_t>(row)] =
          quadratic[row * (d + 2)] + of_multiplier;
      multipliers_ += of_multiplier;
    }
  }
}

std::vector<double> DualMatrix::residual_columns() const {
  const Eigen::Index size = problem_.dimension + 1, scalars = structure_.scalars();
  const Eigen::Index columns = residual_.front().cols();
  std::vector<double> result(static_cast<std::size_t>(scalars * columns));
  Eigen::Map<Eigen::MatrixXd> all(result.data(), scalars, columns);
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i)
    all.middleRows(i * size, size) = residual_[problem_.moving[i]];
  return result;
}

std::optional<double> DualMatrix::gap(double slack) {
  if (structure_.blocks() == 0) return 0;
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const double relative = 8 * kEpsilon * std::sqrt(structure_.scalars());
  double lowered = 4 * kEpsilon * multipliers_;
  std::vector<double> shift(magnitudes_.size());
  for (std::size_t i = 0; i < shift.size(); ++i) shift[i] = -relative * magnitudes_[i];
  if (!factor_->factorize({.lambda = 1, .diagonal = shift.data()})) {
    const double mu = slack / (4.0 * problem_.dimension * structure_.blocks());
    for (std::size_t i = 0; i < shift.size(); ++i) shift[i] += mu * rotation_rows_[i];
    if (!factor_->factorize({.lambda = 1, .diagonal = shift.data()})) return std::nullopt;
    lowered += slack;
  }
  const std::vector<double> right = residual_columns();
  std::vector<double> solution = right;
  factor_->solve(solution);
  double magnitude = 0;
  for (std::size_t i = 0; i < right.size(); ++i) magnitude += std::abs(right[i] * solution[i]);
  const double gap = lowered + std::max(0.0, dot(right, solution)) + relative * magnitude;
  return std::isfinite(gap) ? std::optional(gap) : std::nullopt;
}

double DualMatrix::largest_diagonal() const {
  double largest = 0;
  for (std::uint32_t i = 0; i < structure_.blocks(); ++i)
    largest = std::max(largest, block(i, structure_.column_start[i]).diagonal().cwiseAbs().maxCoeff());
  return largest;
}

std::optional<std::vector<double>> DualMatrix::negative_direction() {
  constexpr double kFirst = 1e-9, kFactor = 10, kLast = 1e3;
  constexpr int kIterations = 40;
  const double scale = largest_diagonal();
  double mu = kFirst;
  while (!factor_->factorize({.lambda = mu * scale, .diagonal = rotation_rows_.data()})) {
    mu *= kFactor;
    if (!(mu < kLast)) return std::nullopt;
  }
  std::mt19937_64 random(structure_.blocks());
  std::vector<double> v(structure_.scalars()), product(v.size());
  for (double& value : v) value = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
  const AssembledSystem system(structure_, values_);
  for (int k = 0; k < kIterations; ++k) {  // inverse iteration
    for (std::size_t i = 0; i < v.size(); ++i) v[i] *= rotation_rows_[i];
    const double length = std::sqrt(dot(v, v));
    for (double& value : v) value /= length;
    factor_->solve(v);
  }
  system.multiply(v.data(), product.data());
  if (!(dot(v, product) < 0)) return std::nullopt;
  const Eigen::Index size = problem_.dimension + 1;
  const Eigen::Map<const Eigen::MatrixXd> parts(v.data(), size, structure_.blocks());
  const double longest = std::sqrt(parts.topRows(size - 1).colwise().squaredNorm().maxCoeff());
  for (double& value : v) value /= longest;
  return v;
}

}  // namespace boxplus::certificate
