// SPDX-License-Identifier: BSD-3-Clause
// The error and the Jacobian of one edge, with the unknown of each column.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

class EdgeRows {
 public:
  EdgeRows(const Graph& graph, const Plan& plan);

  /// The unknown of a column: a tangent direction of a block. The block is BlockStructure::kAbsent if the
  /// vertex does not move.
  struct Column {
    std::uint32_t block, direction;
  };

  /// Linearizes an edge of the plan at the current estimates. Everything below describes the last edge.
  void linearize(const detail::EdgePool& pool, std::uint32_t edge, bool force_numeric);
  int rows() const { return tile_.rows; }
  const double* error() const { return error_.data(); }
  std::span<const Column> columns() const { return columns_; }
  const double* column(std::size_t c) const {
    return jacobian_.data() + c * static_cast<std::size_t>(tile_.rows);
  }

 private:
  const Graph& graph_;
  std::vector<std::vector<std::uint32_t>> block_of_;  // per pool and slot
  detail::EdgeTile tile_;
  std::vector<double> error_, jacobian_;
  std::vector<Column> columns_;
};

}  // namespace boxplus
