// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/stuck.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace boxplus {
namespace {

/// The weighted e² of the enabled active edges that are finite.
std::vector<double> chi2_of_edges(const Graph& graph, const Plan& plan) {
  std::vector<double> result;
  result.reserve(plan.edge_count);
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      double chi2 = 0;
      if (pool.enabled(edge)) pool.chi2(std::span(&edge, 1), &chi2);
      if (chi2 > 0 && std::isfinite(chi2)) result.push_back(chi2);
    }
  }
  return result;
}

}  // namespace

bool few_edges_dominate(const Graph& graph, const RunSystem& system) {
  constexpr double kTimes = 10;  // normal errors with two rows have a mean of 1.44 medians
  const std::vector<double> chi2 = chi2_of_edges(graph, system.plan());
  double sum = 0;
  for (const double value : chi2) sum += value;
  const double edges = system.sum(static_cast<double>(chi2.size()));
  const double limit = system.sum(sum) / (kTimes * std::max(1.0, edges));
  const auto below = std::ranges::count_if(chi2, [&](double value) { return value < limit; });
  return system.sum(static_cast<double>(below)) > edges / 2;  // so the median is below the limit
}

}  // namespace boxplus
