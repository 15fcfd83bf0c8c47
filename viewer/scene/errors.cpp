// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace boxplus::viewer {
namespace {

using PoolValues = std::vector<std::vector<double>>;  // by pool and slot

/// eᵀΩe of each edge.
PoolValues chi2_of_edges(const Graph& graph) {
  PoolValues values;
  for (const auto& pool : graph.edge_pools()) {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t edge = 0; edge < pool->slots(); ++edge) {
      if (pool->alive(edge)) edges.push_back(edge);
    }
    std::vector<double> chi2(edges.size());
    pool->chi2(edges, chi2.data());
    std::vector<double>& by_slot = values.emplace_back(pool->slots());
    for (std::size_t k = 0; k < edges.size(); ++k) by_slot[edges[k]] = chi2[k];
  }
  return values;
}

std::vector<float> point_errors(const Graph& graph, const Structure& structure, const PoolValues& chi2) {
  struct Sum {
    double chi2 = 0, count = 0;
  };
  std::vector<std::vector<Sum>> sums;  // by pool and slot
  for (const auto& pool : graph.vertex_pools()) sums.emplace_back(pool->slots());
  for (std::size_t index = 0; index < chi2.size(); ++index) {
    const detail::EdgePool& pool = *graph.edge_pools()[index];
    for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
      if (!pool.alive(edge)) continue;
      int position = 0;
      for (const std::uint32_t slot : pool.vertex_slots(edge)) {
        Sum& sum = sums[pool.vertex_pool(edge, position++)][slot];
        sum.chi2 += chi2[index][edge];
        ++sum.count;
      }
    }
  }
  std::vector<float> errors;
  for (const VertexGroup& group : structure.vertices) {
    if (group.shape != Shape::kPoint) continue;
    for (const std::uint32_t slot : group.slots) {
      const Sum& sum = sums[group.pool][slot];
      errors.push_back(static_cast<float>(std::sqrt(sum.chi2 / std::max(1.0, sum.count))));
    }
  }
  return errors;
}

/// As Graph::weight(), but at most 1.
double weight_of(const detail::EdgePool& pool, std::uint32_t edge, double chi2) {
  if (!pool.enabled(edge)) return 0;
  const RobustKernel* kernel = pool.kernel(edge);
  return kernel ? std::clamp((*kernel)(chi2).first, 0.0, 1.0) : 1;
}

}  // namespace

Errors read_errors(const Graph& graph, const Structure& structure, const Verdicts& verdicts) {
  const PoolValues chi2 = chi2_of_edges(graph);
  Errors errors;
  if (structure.is_bundle) errors.points = point_errors(graph, structure, chi2);
  errors.chi2.reserve(structure.line_edges.size());
  errors.weights.reserve(structure.line_edges.size());
  bool has_weights = false;
  for (const LineGroup& group : structure.line_groups) {
    const detail::EdgePool& pool = *graph.edge_pools()[group.pool];
    for (std::uint32_t line = group.first; line < group.first + group.count; ++line) {
      const std::uint32_t edge = structure.line_edges[line];
      const double value = chi2[group.pool][edge];
      errors.chi2.push_back(static_cast<float>(value / std::max(1, pool.shape(edge).rows)));
      errors.weights.push_back(static_cast<float>(weight_of(pool, edge, value)));
      has_weights = has_weights || !pool.enabled(edge) || pool.kernel(edge);
    }
  }
  if (!has_weights) errors.weights.clear();
  errors.verdicts = verdicts_of_lines(graph, structure, verdicts);
  return errors;
}

}  // namespace boxplus::viewer
