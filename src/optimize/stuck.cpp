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

bool few_edges_dominate(const Graph& graph, const Plan& plan) {
  constexpr double kTimes = 10;  // normal errors with two rows have a mean of 1.44 medians
  std::vector<double> chi2 = chi2_of_edges(graph, plan);
  if (chi2.empty()) return false;
  double sum = 0;
  for (const double value : chi2) sum += value;
  const auto middle = chi2.begin() + static_cast<std::ptrdiff_t>(chi2.size() / 2);
  std::nth_element(chi2.begin(), middle, chi2.end());
  return sum > kTimes * *middle * static_cast<double>(chi2.size());
}

}  // namespace boxplus
