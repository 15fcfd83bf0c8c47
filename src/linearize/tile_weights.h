// SPDX-License-Identifier: BSD-3-Clause
// The information matrices and the robust weights of the edges of a tile.
//
// The correction of Triggs adds a rank-one term to H: ρ′ JᵀΩJ + 2ρ″ JᵀΩe eᵀΩJ. Instead of it, the Jacobian
// and the error of the edge are changed: with J′ = (I + β e eᵀΩ) J and e′ = e / r, r = √(1 + 2ρ″ e² / ρ′), β
// = (r − 1) / e², e² = eᵀΩe, the sum is ρ′ J′ᵀΩJ′, and the gradient ρ′ J′ᵀΩe′ is still ρ′ JᵀΩe (Triggs et
// al., 2000, §4.3). So all code for weighted edges works.
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

  /// Computes ρ′ from the errors of the tile. If `triggs` is true, then changes its errors and Jacobians.
  void weigh(const detail::EdgePool& pool, std::span<const std::uint32_t> edges, const detail::EdgeTile& tile,
             bool triggs);
  /// Reads Ω.
  void read_informations(const detail::EdgePool& pool, std::span<const std::uint32_t> edges, int rows);

  /// All Ω have this kind.
  dense::EdgeNumbers::Kind kind() const { return kind_; }
  /// The values of Ω of each edge.
  const double* const* omegas() const { return omegas_.data(); }
  /// ρ′ of each edge, or null if all of them are 1.
  const double* weights() const { return weights_.empty() ? nullptr : weights_.data(); }
  double weight(std::size_t k) const { return weights_.empty() ? 1 : weights_[k]; }

 private:
  template <int Lanes>
  void correct(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
               const detail::EdgeTile& tile);

  dense::EdgeNumbers::Kind kind_ = dense::EdgeNumbers::kScalar;
  std::vector<const double*> omegas_;
  std::vector<double> omega_;           // all Ω as full matrices, if their kinds differ
  std::vector<double> error_;           // of one edge
  std::vector<double> weights_;         // empty if no edge has a robust kernel
  std::vector<double> second_;          // 2ρ″ of each edge, limited as EdgeWeight::second
  std::vector<double> squares_;         // eᵀΩe of each edge
  std::vector<double> weighted_error_;  // Ωe of one edge, or of a group of edges in lanes
};

}  // namespace boxplus
