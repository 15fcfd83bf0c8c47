// SPDX-License-Identifier: BSD-3-Clause
// A sparse LDLᵀ factorization with 32 digits, for systems that are too ill-conditioned for double.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/double_double.h"
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// Factorizes A + λD = LDLᵀ scalar by scalar, one row of L after the other (Davis, "Algorithm 849: A concise
/// sparse Cholesky factorization package", 2005). It has neither supernodes nor threads, and each operation
/// takes about 25 operations in double. So it takes about 100 times as long as the block Cholesky, and
/// callers use it only where double fails.
class DoubleDoubleCholesky {
 public:
  /// Orders the blocks by approximate minimum degree, but the blocks of `last` at the end, and counts the
  /// values of L. May throw Stopped.
  void analyze(const BlockStructure& structure, std::span<const std::uint32_t> last, const StopToken& stop);
  /// The number of multiplications in one factorization. Each takes about 15 ns.
  double multiplications() const { return multiplications_; }
  /// The number of multiplications in one call of solve().
  double multiplications_to_solve() const { return 2 * static_cast<double>(rows_.size()); }
  /// `values` are the values of the structure. A pivot d counts as lost if d ≤ 1e-28 · vᵀ diag(A + λD) v,
  /// with v as in lost_pivot.h. So matrices with a scaled condition number below 1e28 are never rejected.
  FactorResult factorize(std::span<const DoubleDouble> values, const Damping& damping, const StopToken& stop);
  /// Replaces b by the solution x of (A + λD) x = b.
  void solve(std::span<DoubleDouble> b) const;

 private:
  /// An entry of the lower triangle of the permuted matrix.
  struct Entry {
    std::uint32_t column, value;
  };

  void list_entries(const BlockStructure& structure, std::span<const std::uint32_t> order);
  std::span<const Entry> entries_of(std::uint32_t row) const {
    return std::span(entries_).subspan(row_start_[row], row_start_[row + 1] - row_start_[row]);
  }
  void count_columns(const StopToken& stop);
  void eliminate(std::uint32_t row, std::span<const DoubleDouble> values, double added);
  FactorResult lost(std::uint32_t row) const;
  double energy(std::uint32_t row) const;

  std::vector<std::uint32_t> scalar_of_, block_of_;  // of each row of the permuted matrix
  std::vector<std::uint32_t> row_start_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> parent_, visited_, reach_;
  std::vector<std::uint64_t> column_start_, column_end_;
  std::vector<std::uint32_t> rows_;  // of the values of L below the diagonal
  std::vector<DoubleDouble> lower_, pivots_, work_;
  std::vector<double> diagonal_;  // of the permuted A + λD
  double multiplications_ = 0;
};

}  // namespace boxplus
