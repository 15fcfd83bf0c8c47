// SPDX-License-Identifier: BSD-3-Clause
// The tile consumer that adds several edges to H and to the gradient at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/graph/edge_pool.h"
#include "kernels/kernel_table.h"

namespace boxplus {

/// Kernels for the common sizes of unary and binary edges; accumulate() is the plain reference for all of
/// them.
class TileAdder {
 public:
  /// Makes room for tiles of `values` numbers of Jacobians and `rows` of errors.
  TileAdder(std::size_t values, std::size_t rows);

  /// Chooses the kernel for edges of these sizes; false where there is none.
  bool choose(int rows, std::span<const int> dims);
  /// Whether the kernel reads tiles in lanes, too.
  bool takes_lanes() const { return add_edges_ != nullptr; }
  /// Adds ρ′ JᵀΩJ and ρ′ JᵀΩe of a tile, edge by edge in its order, where `targets` says (Scatter).
  void add(const EdgePool& pool, std::span<const std::uint32_t> edges, const EdgeTile& tile,
           std::span<const std::uint32_t* const> targets, double* values, double* gradient);

 private:
  const double* weights() const { return weights_.empty() ? nullptr : weights_.data(); }
  void weigh(const EdgePool& pool, std::span<const std::uint32_t> edges, const EdgeTile& tile);

  void add_binary(const EdgeTile& tile, InformationKind kind, const std::uint32_t* const* targets,
                  double* values, double* gradient);

  dense::AddEdges add_edges_ = nullptr;             // binary
  dense::AddUnaryEdges add_unary_edges_ = nullptr;  // one of the two at most
  std::vector<double> jacobian_, error_;            // in lanes
  std::vector<double> omega_;                       // of tiles with Ω of several kinds: all in full
  std::vector<double> weights_;                     // empty where no edge has a robust kernel
  std::vector<const double*> omegas_;
};

}  // namespace boxplus
