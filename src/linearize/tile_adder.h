// SPDX-License-Identifier: BSD-3-Clause
// Adds the edges of a tile to H and to the gradient, several edges at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/graph/edge_pool.h"
#include "kernels/kernel_table.h"
#include "linearize/placed_tile.h"

namespace boxplus {

/// Uses kernels for the common sizes of edges. accumulate() does the same for edges of any
/// size, one by one.
class TileAdder {
 public:
  /// Allocates memory for tiles with `values` values of Jacobians and `rows` values of errors.
  TileAdder(std::size_t values, std::size_t rows);

  /// Chooses the kernel for edges of these sizes. Returns false if there is no such kernel.
  bool choose(int rows, std::span<const int> dims);
  /// Whether the chosen kernel also accepts tiles with EdgeTile::in_lanes.
  bool takes_lanes() const { return add_edges_ != nullptr; }
  /// Adds ρ′ JᵀΩJ and ρ′ JᵀΩe of a tile, in the order of its edges, at the places in `targets` (see Scatter).
  void add(const PlacedTile& edges, double* values, double* gradient);

 private:
  void add_in_lanes(const PlacedTile& edges, double* values, double* gradient);

  dense::AddEdges add_edges_ = nullptr;             // the kernel for edges in lanes
  dense::AddUnaryEdges add_unary_edges_ = nullptr;  // the kernel, if the edges are unary
  std::vector<double> jacobian_, error_;            // copies of a tile's Jacobians and errors in lanes
};

}  // namespace boxplus
