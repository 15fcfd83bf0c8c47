// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/tile_weights.h"

#include <algorithm>
#include <cmath>

#include "linearize/accumulate.h"

namespace boxplus {
namespace {

static_assert(static_cast<int>(detail::InformationKind::kScalar) == dense::EdgeNumbers::kScalar &&
              static_cast<int>(detail::InformationKind::kDiagonal) == dense::EdgeNumbers::kDiagonal &&
              static_cast<int>(detail::InformationKind::kFull) == dense::EdgeNumbers::kFull);

constexpr int kLanes = detail::EdgeTile::kLanes;

/// Copies the error of edge k of a tile.
void copy_error(const detail::EdgeTile& tile, std::size_t k, double* out) {
  const auto rows = static_cast<std::size_t>(tile.rows);
  for (std::size_t r = 0; r < rows; ++r) {
    out[r] =
        tile.in_lanes ? tile.error[(k / kLanes * rows + r) * kLanes + k % kLanes] : tile.error[k * rows + r];
  }
}

}  // namespace

TileWeights::TileWeights(std::size_t rows)
    : omegas_(detail::EdgeTile::kCapacity),
      omega_(rows * dense::kMostEdgeRows),
      error_(rows),
      weighted_error_(2 * rows + kLanes) {
  for (auto* values : {&weights_, &second_, &squares_}) values->reserve(detail::EdgeTile::kCapacity);
}

void TileWeights::read_informations(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                                    int rows) {
  const auto n = static_cast<std::size_t>(rows);
  omega_.resize(std::max(omega_.size(), edges.size() * n * (n + 1) / 2));
  kind_ =
      static_cast<dense::EdgeNumbers::Kind>(pool.informations(edges, rows, omegas_.data(), omega_.data()));
}

void TileWeights::weigh(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                        const detail::EdgeTile& tile, bool triggs) {
  for (auto* values : {&weights_, &second_, &squares_}) values->clear();
  if (!pool.has_kernels()) return;
  bool is_corrected = false;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    EdgeWeight weight;
    double e2 = 0;
    if (const RobustKernel* kernel = pool.kernel(edges[k])) {
      copy_error(tile, k, error_.data());
      e2 = pool.information(edges[k], tile.rows).squared_norm(error_.data());
      weight = edge_weight(kernel, e2, triggs);
    }
    weights_.push_back(weight.first);
    second_.push_back(weight.second);
    squares_.push_back(e2);
    is_corrected = is_corrected || weight.second != 0;
  }
  if (!is_corrected) return;
  tile.in_lanes ? correct<kLanes>(pool, edges, tile) : correct<1>(pool, edges, tile);
}

/// Changes the errors and Jacobians of the tile, which has `Lanes` edges in lanes.
template <int Lanes>
void TileWeights::correct(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                          const detail::EdgeTile& tile) {
  const int rows = tile.rows, count = static_cast<int>(edges.size());
  double* const weighted = weighted_error_.data();
  for (int first = 0; first < count; first += Lanes) {
    double* const error = tile.error + first * rows;
    double* const jacobian = tile.jacobian + first * rows * tile.cols;
    double beta[Lanes] = {}, inverse_root[Lanes];
    std::fill_n(inverse_root, Lanes, 1.0);
    std::fill_n(weighted, rows * Lanes, 0.0);
    for (int lane = 0; lane < std::min(Lanes, count - first); ++lane) {
      const auto k = static_cast<std::size_t>(first + lane);
      if (second_[k] == 0 || weights_[k] == 0) continue;
      const double root = std::sqrt(1 + second_[k] * squares_[k] / weights_[k]);
      beta[lane] = (root - 1) / squares_[k];
      inverse_root[lane] = 1 / root;
      copy_error(tile, k, error_.data());
      double* const product = weighted + rows * Lanes;
      pool.information(edges[k], rows).apply(error_.data(), 1, product);
      for (int r = 0; r < rows; ++r) weighted[r * Lanes + lane] = product[r];
    }
    for (int c = 0; c < tile.cols; ++c) {
      double* const column = jacobian + c * rows * Lanes;
      double along[Lanes] = {};
      for (int r = 0; r < rows; ++r) {
        for (int lane = 0; lane < Lanes; ++lane)
          along[lane] += weighted[r * Lanes + lane] * column[r * Lanes + lane];
      }
      for (int r = 0; r < rows; ++r) {
        for (int lane = 0; lane < Lanes; ++lane)
          column[r * Lanes + lane] += error[r * Lanes + lane] * (beta[lane] * along[lane]);
      }
    }
    for (int r = 0; r < rows; ++r) {
      for (int lane = 0; lane < Lanes; ++lane) error[r * Lanes + lane] *= inverse_root[lane];
    }
  }
}

}  // namespace boxplus
