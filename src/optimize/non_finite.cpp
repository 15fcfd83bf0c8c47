// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/non_finite.h"

#include <cmath>
#include <limits>
#include <vector>

#include "boxplus/base/function_ref.h"

namespace boxplus {
namespace {

/// The active edge with the largest `size`. A size that is not finite counts as the largest.
EdgeRef largest_edge(const Graph& graph, const Plan& plan,
                     detail::FunctionRef<double(const detail::EdgePool&, std::uint32_t)> size) {
  double largest = -1;
  EdgeRef result;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (!pool.enabled(edge)) continue;
      double value = size(pool, edge);
      if (!std::isfinite(value)) value = std::numeric_limits<double>::infinity();
      if (value <= largest) continue;
      largest = value;
      result = {list.pool, edge, pool.generation(edge)};
    }
  }
  return result;
}

/// The trace of JᵀΩJ.
double curvature_of(const detail::EdgePool& pool, std::uint32_t edge, bool numeric) {
  const detail::EdgeShape shape = pool.shape(edge);
  std::vector<double> error(static_cast<std::size_t>(shape.rows));
  std::vector<double> jacobian(static_cast<std::size_t>(shape.rows * shape.cols));
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  pool.linearize(std::span(&edge, 1), tile, numeric);
  double trace = 0;
  for (int k = 0; k < shape.cols; ++k)
    trace += pool.information(edge, shape.rows).squared_norm(tile.jacobian + k * shape.rows);
  return trace;
}

}  // namespace

std::string edge_text(const Graph& graph, const EdgeRef& edge) {
  std::string text = "the edge " + std::string(graph.edge_pools()[edge.pool]->type_name());
  text += " between vertices";
  for (const VertexRef& vertex : graph.vertices(edge)) text += " " + std::to_string(graph.id(vertex));
  return text;
}

std::string describe_non_finite(const Graph& graph, BatchSystem& system) {
  const Linearizer& linearizer = system.linearizer();
  const LinearizeOptions& options = system.linearize_options();
  if (const auto edge = linearizer.find_non_finite_error())
    return "the error (or its robust kernel) of " + edge_text(graph, *edge) + " is NaN or infinite";
  if (const auto edge = linearizer.find_non_finite_jacobian(options))
    return "a Jacobian (or the weight of the robust kernel) of " + edge_text(graph, *edge) +
           " is NaN or infinite";
  if (!std::isfinite(system.chi2())) {
    const auto chi2 = [](const detail::EdgePool& pool, std::uint32_t edge) {
      double value = 0;
      pool.chi2(std::span(&edge, 1), &value);
      return value;
    };
    return "chi2 overflows; the largest part comes from " +
           edge_text(graph, largest_edge(graph, system.plan(), chi2));
  }
  const auto curvature = [&](const detail::EdgePool& pool, std::uint32_t edge) {
    return curvature_of(pool, edge, options.numeric_jacobians);
  };
  return "the linear system overflows; the largest Jacobian belongs to " +
         edge_text(graph, largest_edge(graph, system.plan(), curvature));
}

}  // namespace boxplus
