// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/tile_adder.h"

#include "plan/plan.h"

namespace boxplus {
namespace {

static_assert(detail::EdgeTile::kLanes == dense::kTileLanes);
static_assert(Scatter::kNowhere == dense::kNoTarget && Scatter::kTransposed == dense::kTransposedTarget);

}  // namespace

TileAdder::TileAdder(std::size_t values, std::size_t rows) : jacobian_(values), error_(rows) {}

bool TileAdder::choose(int rows, std::span<const int> dims) {
  const dense::KernelTable& kernels = dense::kernels();
  add_edges_ = kernels.add_edges_for(rows, dims.data(), static_cast<int>(dims.size()));
  add_unary_edges_ = dims.size() == 1 ? kernels.add_unary_edges_for(rows, dims[0]) : nullptr;
  return add_edges_ != nullptr || add_unary_edges_ != nullptr;
}

void TileAdder::add(const PlacedTile& edges, double* values, double* gradient) {
  const detail::EdgeTile& tile = edges.tile;
  edges.weights.read_informations(edges.pool, edges.edges, tile.rows);
  if (add_edges_ != nullptr) return add_in_lanes(edges, values, gradient);
  add_unary_edges_({tile.count, tile.jacobian, tile.error, edges.weights.kind(), edges.weights.omegas(),
                    edges.weights.weights(), edges.targets.data(), values, gradient});
}

void TileAdder::add_in_lanes(const PlacedTile& edges, double* values, double* gradient) {
  const detail::EdgeTile& tile = edges.tile;
  const double *jacobian = tile.jacobian, *error = tile.error;
  if (!tile.in_lanes) {
    dense::kernels().to_lanes(jacobian, tile.rows * tile.cols, tile.count, jacobian_.data());
    dense::kernels().to_lanes(error, tile.rows, tile.count, error_.data());
    jacobian = jacobian_.data();
    error = error_.data();
  }
  add_edges_({tile.count, jacobian, error, edges.weights.kind(), edges.weights.omegas(),
              edges.weights.weights(), edges.targets.data(), values, gradient});
}

}  // namespace boxplus
