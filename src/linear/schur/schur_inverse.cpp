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

/// Blocks of S⁻¹ for kept blocks of H.
class ReducedInverse {
 public:
  explicit ReducedInverse(const Schur& schur) : schur_(schur), structure_(schur.reduced_structure()) {}

  void want(std::uint32_t i, std::uint32_t j) {
    if (blocks_.size() >= room_) drop_duplicates();
    const std::uint32_t at_i = schur_.place_of(i).block, at_j = schur_.place_of(j).block;
    blocks_.push_back({std::max(at_i, at_j), std::min(at_i, at_j)});
  }

  bool compute(LinearSolver& inner, const StopToken& stop) {
    drop_duplicates();
    std::size_t size = 0;
    for (const BlockCoordinate& block : blocks_) {
      start_.push_back(size);
      size += std::size_t{structure_.dim(block.row)} * structure_.dim(block.column);
    }
    values_.resize(size);
    return blocks_.empty() || inner.selected_inverse(blocks_, values_.data(), stop);
  }

  /// Copies block (i, j), which must have been requested.
  void read(std::uint32_t i, std::uint32_t j, Eigen::Ref<MatrixXd> out) const {
    const Schur::Place at_i = schur_.place_of(i), at_j = schur_.place_of(j);
    const BlockCoordinate lower{std::max(at_i.block, at_j.block), std::min(at_i.block, at_j.block)};
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), lower, precedes);
    const double* values = values_.data() + start_[found - blocks_.begin()];
    const Eigen::Map<const MatrixXd> stored(values, structure_.dim(lower.row), structure_.dim(lower.column));
    if (at_i.block >= at_j.block) {
      out = stored.block(at_i.first, at_j.first, out.rows(), out.cols());
    } else {
      out = stored.block(at_j.first, at_i.first, out.cols(), out.rows()).transpose();
    }
  }

 private:
  void drop_duplicates() {
    std::sort(blocks_.begin(), blocks_.end(), precedes);
    const auto same = [](const BlockCoordinate& a, const BlockCoordinate& b) {
      return a.row == b.row && a.column == b.column;
    };
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end(), same), blocks_.end());
    room_ = std::max(room_, 2 * blocks_.size());
  }

  const Schur& schur_;
  const BlockStructure& structure_;
  std::vector<BlockCoordinate> blocks_;
  std::size_t room_ = std::size_t{1} << 20;  // the size of blocks_ at which duplicates are dropped
  std::vector<std::size_t> start_;
  std::vector<double> values_;
};

/// Computes (H + λD)⁻¹ as Mᵀ S⁻¹ M with M = [−Y, I] and the Y of invert_blocks(), plus (V + λD)⁻¹ on the
/// diagonal of the eliminated blocks.
class Inverter {
 public:
  Inverter(const Schur& schur, const StopToken& stop) : schur_(schur), stop_(stop), reduced_(schur) {}

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

  /// Calls f for each kept block of H whose rows of S⁻¹ a block of H needs. A kept block needs its own rows.
  /// An eliminated block needs the rows of the kept blocks that an edge joins with it.
  template <class F>
  void for_each_reached(std::uint32_t block, F&& f) const {
    if (eliminated(block)) {
      schur_.for_each_coupled(
          block, [&](std::uint32_t row, const double*, int) { f(schur_.eliminated_blocks() + row); });
    } else {
      f(block);
    }
  }

  template <class F>
  void for_each_pair(const BlockCoordinate& block, F&& f) const {
    for_each_reached(block.row, [&](std::uint32_t i) {
      for_each_reached(block.column, [&](std::uint32_t j) { f(i, j); });
    });
  }

  /// The kept blocks of H with nonzero rows in a block column of M, and the transposed values of these rows.
  struct Column {
    std::vector<std::uint32_t> rows;
    MatrixXd transposed;
  };

  Column column_of(std::uint32_t block) const {
    Column column;
    Eigen::Index size = 0;
    for_each_reached(block, [&](std::uint32_t row) {
      column.rows.push_back(row);
      size += dim(row);
    });
    if (!eliminated(block)) {
      column.transposed = MatrixXd::Identity(size, size);
      return column;
    }
    column.transposed.resize(dim(block), size);
    Eigen::Index at = 0;
    schur_.for_each_coupled(block, [&](std::uint32_t, const double* w, int rows) {
      column.transposed.middleCols(at, rows) = -Eigen::Map<const MatrixXd>(w, rows, dim(block)).transpose();
      for (int r = 0; r < rows; ++r) schur_.solve_eliminated(block, column.transposed.col(at++).data());
    });
    return column;
  }

  MatrixXd block_of_inverse(const BlockCoordinate& block) const {
    const Column left = column_of(block.row), right = column_of(block.column);
    MatrixXd inverse(left.transposed.cols(), right.transposed.cols());  // part of S⁻¹
    Eigen::Index r = 0;
    for (const std::uint32_t i : left.rows) {
      Eigen::Index c = 0;
      for (const std::uint32_t j : right.rows) {
        reduced_.read(i, j, inverse.block(r, c, dim(i), dim(j)));
        c += dim(j);
      }
      r += dim(i);
    }
    if (!eliminated(block.row) && !eliminated(block.column)) return inverse;
    MatrixXd result = left.transposed * inverse * right.transposed.transpose();
    if (block.row != block.column) return result;
    MatrixXd own = MatrixXd::Identity(result.rows(), result.cols());
    for (Eigen::Index c = 0; c < own.cols(); ++c) schur_.solve_eliminated(block.row, own.col(c).data());
    return result + own;
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
