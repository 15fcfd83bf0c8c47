// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/tile_weights.h"

#include <algorithm>

#include "linearize/accumulate.h"

namespace boxplus {
namespace {

static_assert(static_cast<int>(detail::InformationKind::kScalar) == dense::EdgeNumbers::kScalar &&
              static_cast<int>(detail::InformationKind::kDiagonal) == dense::EdgeNumbers::kDiagonal &&
              static_cast<int>(detail::InformationKind::kFull) == dense::EdgeNumbers::kFull);

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

TileWeights::TileWeights(std::size_t rows)
    : omegas_(detail::EdgeTile::kCapacity), omega_(rows * dense::kMostEdgeRows), error_(rows) {
  weights_.reserve(detail::EdgeTile::kCapacity);
}

void TileWeights::compute(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                          const detail::EdgeTile& tile) {
  weigh(pool, edges, tile);
  const auto rows = static_cast<std::size_t>(tile.rows);
  omega_.resize(std::max(omega_.size(), edges.size() * rows * (rows + 1) / 2));
  kind_ = static_cast<dense::EdgeNumbers::Kind>(
      pool.informations(edges, tile.rows, omegas_.data(), omega_.data()));
}

void TileWeights::weigh(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                        const detail::EdgeTile& tile) {
  weights_.clear();
  if (!pool.has_kernels()) return;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RobustKernel* kernel = pool.kernel(edges[k]);
    if (kernel == nullptr) {
      weights_.push_back(1);
      continue;
    }
    copy_error(tile, k, error_.data());
    const double e2 = pool.information(edges[k], tile.rows).squared_norm(error_.data());
    weights_.push_back(edge_weight(kernel, e2, false).first);
  }
}

}  // namespace boxplus
