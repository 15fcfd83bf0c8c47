// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/edge_linearizer.h"

#include "base/paced_stop.h"
#include "linearize/accumulate.h"
#include "linearize/placed_tile.h"
#include "linearize/tile_memory.h"

namespace boxplus {
namespace {

/// Lists the tangent sizes of an edge's vertices.
void vertex_dims(const Graph& graph, const detail::EdgePool& pool, std::uint32_t edge,
                 std::vector<int>& dims) {
  dims.clear();
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    dims.push_back(graph.vertex_pools()[pool.vertex_pool(edge, static_cast<int>(i))]->tangent_dim(slots[i]));
  }
}

/// For edges without a kernel.
void add_one_by_one(const PlacedTile& edges, TileMemory& memory, const EdgeLinearizer::Sums& sums) {
  const detail::EdgeTile& tile = edges.tile;
  for (std::size_t k = 0; k < edges.edges.size(); ++k) {
    const double* error = tile.error + k * static_cast<std::size_t>(tile.rows);
    const double* jacobian = tile.jacobian + k * static_cast<std::size_t>(tile.rows * tile.cols);
    accumulate({tile.rows, tile.cols, edges.dims, error, jacobian},
               edges.pool.information(edges.edges[k], tile.rows), edges.weights.weight(k), edges.targets[k],
               sums.values, sums.gradient, memory.weighted.data(), memory.weighted_error.data(),
               memory.dense.data());
  }
}

}  // namespace

bool fits_kernels(const detail::EdgePool& pool, std::uint32_t edge) {
  return pool.uniform_shape() && tile_capacity(pool.shape(edge)) >= detail::EdgeTile::kLanes;
}

bool EdgeLinearizer::add(const Scatter& scatter, std::uint32_t begin, std::uint32_t end, TileMemory& memory,
                         const LinearizeOptions& options, PacedStop& pace, const Sums& sums) const {
  const detail::EdgePool& pool = *graph_->edge_pools()[scatter.pool];
  vertex_dims(*graph_, pool, scatter.edges[begin], memory.dims);
  const bool by_tiles = fits_kernels(pool, scatter.edges[begin]) &&
                        memory.adder.choose(pool.shape(scatter.edges[begin]).rows, memory.dims);
  const bool in_lanes = by_tiles && memory.adder.takes_lanes();
  return for_each_tile(scatter, begin, end, memory, options, in_lanes, pace, [&](const PlacedTile& edges) {
    if (by_tiles) {
      memory.adder.add(edges, sums.values, sums.gradient);
    } else {
      add_one_by_one(edges, memory, sums);
    }
  });
}

bool EdgeLinearizer::for_each_tile(const Scatter& scatter, std::uint32_t begin, std::uint32_t end,
                                   TileMemory& memory, const LinearizeOptions& options, bool in_lanes,
                                   PacedStop& pace, detail::FunctionRef<void(const PlacedTile&)> f) const {
  const detail::EdgePool& pool = *graph_->edge_pools()[scatter.pool];
  const bool uniform = pool.uniform_shape();
  const detail::EdgeShape shape = pool.shape(scatter.edges[begin]);
  const std::size_t capacity = uniform ? static_cast<std::size_t>(tile_capacity(shape)) : 1;
  detail::EdgeTile tile;
  tile.error = memory.error.data();
  tile.jacobian = memory.jacobian.data();
  vertex_dims(*graph_, pool, scatter.edges[begin], memory.dims);
  for (std::uint32_t next = begin; next < end;) {
    const auto edges = memory.gather(pool, scatter, next, end, capacity);
    if (edges.empty()) continue;
    if (pace.is_raised_after(static_cast<std::int64_t>(edges.size()))) return false;
    tile.in_lanes = in_lanes;
    pool.linearize(edges, tile, options.numeric_jacobians);
    memory.weights.weigh(pool, edges, tile, options.triggs_correction);
    if (!uniform) vertex_dims(*graph_, pool, edges[0], memory.dims);
    f({pool, edges, tile, memory.dims, std::span(memory.targets).first(edges.size()), memory.weights});
  }
  return true;
}

}  // namespace boxplus
