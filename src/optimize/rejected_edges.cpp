// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/rejected_edges.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>

#include "boxplus/base/parallel.h"
#include "boxplus/optimize/report.h"
#include "robust/is_redescending.h"

namespace boxplus {
namespace {

constexpr std::size_t kTile = detail::EdgeTile::kCapacity;

/// The enabled edges of a tile that have a robust kernel.
struct RobustTile {
  std::array<std::uint32_t, kTile> edges{}, places{};  // slots, and positions in the list
  std::array<double, kTile> chi2{};
  std::size_t count = 0;

  RobustTile(const detail::EdgePool& pool, std::span<const std::uint32_t> list, std::size_t first) {
    for (std::size_t k = first; k < std::min(first + kTile, list.size()); ++k) {
      if (!pool.enabled(list[k]) || pool.kernel(list[k]) == nullptr) continue;
      edges[count] = list[k];
      places[count++] = static_cast<std::uint32_t>(k);
    }
    if (count > 0) pool.chi2(std::span(edges).first(count), chi2.data());
  }
};

/// Calls f(position in the list, is rejected, has a redescending kernel) for each robust edge of a tile.
template <class F>
void for_each_robust_edge(const detail::EdgePool& pool, const RobustTile& tile, F&& f) {
  const RobustKernel* last = nullptr;
  bool redescends = false;
  for (std::size_t k = 0; k < tile.count; ++k) {
    const RobustKernel* kernel = pool.kernel(tile.edges[k]);
    if (kernel != last) redescends = is_redescending(*kernel);  // edges often share a kernel
    last = kernel;
    const double e2 = tile.chi2[k];
    f(tile.places[k], std::isfinite(e2) && (*kernel)(e2).first < Report::kRejectedWeight, redescends);
  }
}

}  // namespace

RejectionCounts count_rejected(const Graph& graph, const Plan& plan, int workers) {
  std::atomic<std::uint32_t> rejected = 0, redescending = 0, by_redescending = 0;
  const auto count = [&](int worker) {
    RejectionCounts own;
    for (const EdgeList& list : plan.edges) {
      const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
      if (!pool.has_kernels()) continue;
      const std::size_t stride = static_cast<std::size_t>(workers) * kTile;
      for (std::size_t first = static_cast<std::size_t>(worker) * kTile; first < list.edges.size();
           first += stride) {
        const RobustTile tile(pool, list.edges, first);
        for_each_robust_edge(pool, tile, [&](std::uint32_t, bool is_rejected, bool redescends) {
          own.rejected += is_rejected;
          own.redescending += redescends;
          own.by_redescending += is_rejected && redescends;
        });
      }
    }
    rejected += own.rejected;
    redescending += own.redescending;
    by_redescending += own.by_redescending;
  };
  detail::parallel_tasks(workers, count);
  return {rejected, redescending, by_redescending};
}

std::vector<std::uint8_t> flag_rejected(const Graph& graph, const Plan& plan) {
  std::vector<std::uint8_t> flags(plan.edge_count, 0);
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    if (!pool.has_kernels()) continue;
    for (std::size_t first = 0; first < list.edges.size(); first += kTile) {
      const RobustTile tile(pool, list.edges, first);
      for_each_robust_edge(pool, tile, [&](std::uint32_t place, bool is_rejected, bool redescends) {
        flags[list.first + place] = is_rejected && redescends;
      });
    }
  }
  return flags;
}

}  // namespace boxplus
