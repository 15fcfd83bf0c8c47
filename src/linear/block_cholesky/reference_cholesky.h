// SPDX-License-Identifier: BSD-3-Clause
// A textbook block Cholesky. Tests compare the supernodal block Cholesky with it.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// A right-looking Cholesky that factorizes one block column after the other, in the order of the structure,
/// and stores the blocks in a map. It has neither a fill-reducing order nor supernodes.
class ReferenceCholesky {
 public:
  ReferenceCholesky(const BlockStructure& structure, std::span<const double> values, const Damping& damping);

  const FactorResult& result() const { return result_; }
  std::vector<double> solve(std::vector<double> b) const;

 private:
  using Block = std::vector<double>;                      // column-major
  using Index = std::pair<std::uint32_t, std::uint32_t>;  // column, row

  bool factor_diagonal(std::uint32_t column);
  void divide_column(std::uint32_t column);
  void update_with(std::uint32_t column);
  std::vector<std::uint32_t> rows_below(std::uint32_t column) const;

  const BlockStructure& structure_;
  std::map<Index, Block> blocks_;
  FactorResult result_;
};

}  // namespace boxplus
