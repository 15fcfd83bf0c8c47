// SPDX-License-Identifier: BSD-3-Clause
// The information matrices and the robust weights of the edges of a tile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/graph/edge_pool.h"
#include "kernels/kernel_table.h"

namespace boxplus {

class TileWeights {
 public:
  /// Allocates memory for tiles with `rows` values of errors. Edges with more than dense::kMostEdgeRows rows
  /// may need more memory later.
  explicit TileWeights(std::size_t rows);

  /// Reads Ω, and computes ρ′ from the errors of the tile.
  void compute(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
               const detail::EdgeTile& tile);

  /// All Ω have this kind.
  dense::EdgeNumbers::Kind kind() const { return kind_; }
  /// The values of Ω of each edge.
  const double* const* omegas() const { return omegas_.data(); }
  /// ρ′ of each edge, or null if all of them are 1.
  const double* weights() const { return weights_.empty() ? nullptr : weights_.data(); }

 private:
  void weigh(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
             const detail::EdgeTile& tile);

  dense::EdgeNumbers::Kind kind_ = dense::EdgeNumbers::kScalar;
  std::vector<const double*> omegas_;
  std::vector<double> omega_;    // all Ω as full matrices, if their kinds differ
  std::vector<double> error_;    // of one edge
  std::vector<double> weights_;  // empty if no edge has a robust kernel
};

}  // namespace boxplus
