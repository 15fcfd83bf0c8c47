// SPDX-License-Identifier: BSD-3-Clause
// Blocks of A⁻¹ for a few rows and columns.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/column_inverse.h"

namespace boxplus {

/// Let E be the unit vectors of the requested rows and columns. Then the requested blocks are blocks of
/// EᵀA⁻¹E = YᵀY with Y = L⁻¹E. A column of Y is zero except on one path of the elimination tree, from its
/// supernode to the root (Gilbert, "Predicting structure in sparse matrix computations", 1994). Therefore,
/// only the supernodes on these paths are read, and nothing is substituted backward.
class PathInverse {
 public:
  PathInverse(const SymbolicFactor& symbolic, std::span<const InverseRequest> requests);

  /// The number of operations of compute().
  double flops() const;
  /// Writes the requested blocks. `panels` is the arena of the factor. Returns false soon after the token is
  /// raised.
  bool compute(const double* panels, const StopToken& stop);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  /// The values of Y for one scalar: one per column of E.
  double* values_at(std::uint32_t position);
  void substitute(const Front& front, const double* panels);
  void write_blocks();

  const SymbolicFactor& symbolic_;
  std::span<const InverseRequest> requests_;
  std::vector<std::uint32_t> blocks_;        // the requested positions in the elimination order, ascending
  std::vector<std::uint32_t> first_column_;  // the first column of E of each of these, and their total number
  std::vector<std::uint32_t> fronts_;        // the supernodes on the paths, ascending
  std::vector<std::uint32_t> first_row_;     // the first row of each supernode in Y, or kNone
  std::uint32_t rows_ = 0;
  std::uint64_t factor_values_ = 0;
  std::vector<double> y_, below_;  // for each scalar, the values of all columns are contiguous
};

}  // namespace boxplus
