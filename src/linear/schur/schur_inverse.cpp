// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/schur_inverse.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "base/paced_stop.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

bool precedes(const BlockCoordinate& a, const BlockCoordinate& b) {
  return a.column != b.column ? a.column < b.column : a.row < b.row;
}

/// Blocks of S⁻¹, found by their coordinates.
class ReducedInverse {
 public:
  explicit ReducedInverse(const BlockStructure& structure) : structure_(structure) {}

  void want(std::uint32_t i, std::uint32_t j) { blocks_.push_back({std::max(i, j), std::min(i, j)}); }

  bool compute(LinearSolver& inner, const StopToken& stop) {
    std::sort(blocks_.begin(), blocks_.end(), precedes);
    const auto same = [](const BlockCoordinate& a, const BlockCoordinate& b) {
      return a.row == b.row && a.column == b.column;
    };
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end(), same), blocks_.end());
    std::size_t size = 0;
    for (const BlockCoordinate& block : blocks_) {
      start_.push_back(size);
      size += std::size_t{structure_.dim(block.row)} * structure_.dim(block.column);
    }
    values_.resize(size);
    return blocks_.empty() || inner.selected_inverse(blocks_, values_.data(), stop);
  }

  /// Block (i, j), which was wanted.
  MatrixXd block(std::uint32_t i, std::uint32_t j) const {
    const BlockCoordinate lower{std::max(i, j), std::min(i, j)};
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), lower, precedes);
    const double* values = values_.data() + start_[static_cast<std::size_t>(found - blocks_.begin())];
    const Eigen::Map<const MatrixXd> stored(values, structure_.dim(lower.row), structure_.dim(lower.column));
    return i >= j ? MatrixXd(stored) : MatrixXd(stored.transpose());
  }

 private:
  const BlockStructure& structure_;
  std::vector<BlockCoordinate> blocks_;
  std::vector<std::size_t> start_;
  std::vector<double> values_;
};

/// The columns of Y, and what follows from them.
class Inverter {
 public:
  Inverter(const Schur& schur, const StopToken& stop)
      : schur_(schur), stop_(stop), reduced_(schur.reduced_structure()) {}

  bool fill(LinearSolver& inner, std::span<const InverseRequest> requests) {
    PacedStop pace(stop_);
    for (const InverseRequest& request : requests) {
      for_each_pair(request.block, [&](std::uint32_t i, std::uint32_t j) { reduced_.want(i, j); });
      if (pace.is_raised_after(1)) return false;
    }
    if (!reduced_.compute(inner, stop_)) return false;
    for (const auto& [block, out] : requests) {
      const MatrixXd inverse = block_of_inverse(block);
      std::copy_n(inverse.data(), inverse.size(), out);
      if (pace.is_raised_after(10)) return false;
    }
    return true;
  }

 private:
  bool eliminated(std::uint32_t block) const { return block < schur_.eliminated_blocks(); }
  std::uint32_t kept(std::uint32_t block) const { return block - schur_.eliminated_blocks(); }

  /// The kept blocks through which a block of H reaches S⁻¹: itself, or those that it is joined with.
  template <class F>
  void for_each_reached(std::uint32_t block, F&& f) const {
    if (eliminated(block)) {
      schur_.for_each_joined(block, [&](std::uint32_t row, const double*, int) { f(row); });
    } else {
      f(kept(block));
    }
  }

  template <class F>
  void for_each_pair(const BlockCoordinate& block, F&& f) const {
    for_each_reached(block.row, [&](std::uint32_t i) {
      for_each_reached(block.column, [&](std::uint32_t j) { f(i, j); });
    });
  }

  /// A block Mᵀ of the column of M that belongs to a block of H; M = [−Y, I], so that H⁻¹ = Mᵀ S⁻¹ M, plus
  /// (V + λD)⁻¹ on the eliminated diagonal.
  struct Factor {
    std::uint32_t row;
    MatrixXd transposed;  // empty: the identity
  };

  std::vector<Factor> factors_of(std::uint32_t block) const {
    if (!eliminated(block)) return {{kept(block), MatrixXd()}};
    std::vector<Factor> factors;
    schur_.for_each_joined(block, [&](std::uint32_t row, const double* w, int rows) {
      factors.push_back({row, -Eigen::Map<const MatrixXd>(w, rows, dim(block)).transpose()});
      MatrixXd& transposed = factors.back().transposed;
      for (int r = 0; r < rows; ++r) schur_.solve_eliminated(block, transposed.col(r).data());
    });
    return factors;
  }

  MatrixXd block_of_inverse(const BlockCoordinate& block) const {
    MatrixXd sum = MatrixXd::Zero(dim(block.row), dim(block.column));
    const std::vector<Factor> left = factors_of(block.row), right = factors_of(block.column);
    for (const Factor& l : left) {
      for (const Factor& r : right) {
        MatrixXd product = reduced_.block(l.row, r.row);
        if (l.transposed.size() > 0) product = l.transposed * product;
        if (r.transposed.size() > 0) product = product * r.transposed.transpose();
        sum += product;
      }
    }
    if (block.row != block.column || !eliminated(block.row)) return sum;
    MatrixXd own = MatrixXd::Identity(sum.rows(), sum.cols());
    for (Eigen::Index c = 0; c < own.cols(); ++c) schur_.solve_eliminated(block.row, own.col(c).data());
    return sum + own;
  }

  Eigen::Index dim(std::uint32_t block) const { return schur_.structure().dim(block); }

  const Schur& schur_;
  const StopToken& stop_;
  ReducedInverse reduced_;
};

}  // namespace

bool invert_blocks(const Schur& schur, LinearSolver& inner, std::span<const InverseRequest> requests,
                   const StopToken& stop) {
  return Inverter(schur, stop).fill(inner, requests);
}

}  // namespace boxplus
