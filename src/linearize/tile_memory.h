// SPDX-License-Identifier: BSD-3-Clause
// What one worker linearises into.
#pragma once

#include <cstdint>
#include <vector>

#include "linearize/lane_adder.h"

namespace boxplus {

struct TileMemory {
  /// For tiles of `values` numbers of Jacobians and `rows` of errors.
  TileMemory(std::size_t values, std::size_t rows)
      : error(rows), jacobian(values), weighted(values), weighted_error(values + rows), lanes(values, rows) {
    edges.reserve(EdgeTile::kCapacity);
    targets.reserve(EdgeTile::kCapacity);
  }

  std::vector<double> error, jacobian, weighted, weighted_error;
  std::vector<std::uint32_t> edges;           // of the tile
  std::vector<const std::uint32_t*> targets;  // of each of them
  std::vector<int> dims;
  LaneAdder lanes;
};

}  // namespace boxplus
