// SPDX-License-Identifier: BSD-3-Clause
// The scratch memory in which one worker linearizes edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linearize/jacobian_products.h"
#include "linearize/tile_adder.h"
#include "plan/plan.h"

namespace boxplus {

struct TileMemory {
  /// Allocates memory for tiles with `values` values of Jacobians and `rows` values of errors. `dense_values`
  /// is the largest dense_scratch() of an edge.
  TileMemory(std::size_t values, std::size_t rows, std::size_t dense_values)
      : error(rows),
        jacobian(values),
        weighted(values),
        weighted_error(values + rows),
        dense(dense_values),
        weights(rows),
        adder(values, rows),
        products(values, rows) {
    edges.resize(detail::EdgeTile::kCapacity);
    targets.resize(detail::EdgeTile::kCapacity);
  }

  /// Gathers at most `capacity` enabled edges from the part [next, end) of a run, with their targets.
  /// Advances `next` past these edges.
  std::span<const std::uint32_t> gather(const detail::EdgePool& pool, const Scatter& scatter,
                                        std::uint32_t& next, std::uint32_t end, std::size_t capacity) {
    const int arity = static_cast<int>(dims.size());
    std::size_t count = 0;
    for (; next < end && count < capacity; ++next) {
      const std::uint32_t edge = scatter.edges[next];
      if (!pool.enabled(edge)) continue;
      edges[count] = edge;
      targets[count++] = scatter.targets_of_edge(next, arity);
    }
    return {edges.data(), count};
  }

  std::vector<double> error, jacobian, weighted, weighted_error, dense;
  std::vector<std::uint32_t> edges;           // the gathered edges
  std::vector<const std::uint32_t*> targets;  // the targets of each gathered edge
  std::vector<int> dims;
  TileWeights weights;  // of the last tile
  TileAdder adder;
  JacobianProducts products;
};

}  // namespace boxplus
