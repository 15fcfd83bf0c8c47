// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "boxplus/graph/edge_pool.h"
#include "linearize/tile_weights.h"

namespace boxplus {

/// A tile of edges. Each edge has the tangent sizes `dims` of its vertices.
struct PlacedTile {
  const detail::EdgePool& pool;
  std::span<const std::uint32_t> edges;
  const detail::EdgeTile& tile;
  std::span<const int> dims;
  std::span<const std::uint32_t* const> targets;  ///< of each edge (Scatter)
  TileWeights& weights;                           ///< has ρ′; reads Ω for those who need it in one form
};

}  // namespace boxplus
