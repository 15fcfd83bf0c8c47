// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/tile_adder.h"

#include "linearize/accumulate.h"

namespace boxplus {
namespace {

static_assert(detail::EdgeTile::kLanes == dense::kTileLanes);
static_assert(Scatter::kNowhere == dense::kNoTarget && Scatter::kTransposed == dense::kTransposedTarget);

/// Copies the error of edge k of a tile.
void copy_error(const detail::EdgeTile& tile, std::size_t k, double* out) {
  const auto rows = static_cast<std::size_t>(tile.rows);
  constexpr std::size_t kLanes = detail::EdgeTile::kLanes;
  for (std::size_t r = 0; r < rows; ++r) {
    out[r] =
        tile.in_lanes ? tile.error[(k / kLanes * rows + r) * kLanes + k % kLanes] : tile.error[k * rows + r];
  }
}

}  // namespace

TileAdder::TileAdder(std::size_t values, std::size_t rows)
    : jacobian_(values),
      error_(rows),
      omega_(rows * dense::kMostEdgeRows),
      omegas_(detail::EdgeTile::kCapacity) {
  weights_.reserve(detail::EdgeTile::kCapacity);
}

bool TileAdder::choose(int rows, std::span<const int> dims) {
  const dense::KernelTable& kernels = dense::kernels();
  add_edges_ = kernels.add_edges_for(rows, dims.data(), static_cast<int>(dims.size()));
  add_unary_edges_ = dims.size() == 1 ? kernels.add_unary_edges_for(rows, dims[0]) : nullptr;
  return add_edges_ != nullptr || add_unary_edges_ != nullptr;
}

void TileAdder::weigh(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                      const detail::EdgeTile& tile) {
  weights_.clear();
  if (!pool.has_kernels()) return;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RobustKernel* kernel = pool.kernel(edges[k]);
    if (kernel == nullptr) {
      weights_.push_back(1);
      continue;
    }
    double error[dense::kMostEdgeRows];
    copy_error(tile, k, error);
    const double e2 = pool.information(edges[k], tile.rows).squared_norm(error);
    weights_.push_back(edge_weight(kernel, e2, false).first);
  }
}

void TileAdder::add(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                    const detail::EdgeTile& tile, std::span<const std::uint32_t* const> targets,
                    double* values, double* gradient) {
  weigh(pool, edges, tile);
  const detail::InformationKind kind = pool.informations(edges, tile.rows, omegas_.data(), omega_.data());
  if (add_edges_ != nullptr) return add_in_lanes(tile, kind, targets.data(), values, gradient);
  add_unary_edges_({tile.count, tile.jacobian, tile.error, static_cast<dense::EdgeNumbers::Kind>(kind),
                    omegas_.data(), weights(), targets.data(), values, gradient});
}

void TileAdder::add_in_lanes(const detail::EdgeTile& tile, detail::InformationKind kind,
                             const std::uint32_t* const* targets, double* values, double* gradient) {
  const double *jacobian = tile.jacobian, *error = tile.error;
  if (!tile.in_lanes) {
    dense::kernels().to_lanes(jacobian, tile.rows * tile.cols, tile.count, jacobian_.data());
    dense::kernels().to_lanes(error, tile.rows, tile.count, error_.data());
    jacobian = jacobian_.data();
    error = error_.data();
  }
  add_edges_({tile.count, jacobian, error, static_cast<dense::EdgeNumbers::Kind>(kind), omegas_.data(),
              weights(), targets, values, gradient});
}

}  // namespace boxplus
