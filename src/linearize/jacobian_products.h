// SPDX-License-Identifier: BSD-3-Clause
// Products of the Jacobians of a tile with vectors, which replace products with H if H is not stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "linearize/placed_tile.h"

namespace boxplus {

/// The entry of a vector that belongs to an entry of the gradient that a chunk computes. Entries of kept
/// vertices begin at `first_kept`; the chunk's copies of them are `copy` entries behind.
struct VectorLayout {
  std::uint32_t first_kept, copy;
};

class JacobianProducts {
 public:
  /// Allocates memory for tiles with `values` values of Jacobians and `rows` values of errors.
  JacobianProducts(std::size_t values, std::size_t rows);

  /// Let J_e and J_k be the columns of an edge's Jacobian for eliminated and for kept vertices. Sets
  /// x_e −= ρ′ J_eᵀ Ω J_k x_k for each edge, in the order of the edges.
  void subtract_coupling(const PlacedTile& edges, VectorLayout layout, double* x);
  /// Σ ρ′ (J d)ᵀ Ω (J d), added in the order of the edges.
  double curvature(const PlacedTile& edges, VectorLayout layout, const double* d);

 private:
  const double* jacobian_in_lanes(const detail::EdgeTile& tile);

  std::vector<double> x_, y_, product_, weighted_;  // of a few edges in lanes; x_ also of all Jacobians
};

}  // namespace boxplus
