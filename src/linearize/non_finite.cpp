// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/non_finite.h"

#include <cmath>
#include <limits>
#include <vector>

#include "base/all_finite.h"
#include "boxplus/base/function_ref.h"
#include "linearize/accumulate.h"

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

/// The first active edge, in pool and slot order, for which a function holds.
std::optional<EdgeRef> find_edge(const Graph& graph, const Plan& plan,
                                 detail::FunctionRef<bool(const detail::EdgePool&, std::uint32_t)> holds) {
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (pool.enabled(edge) && holds(pool, edge)) return EdgeRef{list.pool, edge, pool.generation(edge)};
    }
  }
  return std::nullopt;
}

struct LinearizedEdge {
  detail::EdgeShape shape;
  std::vector<double> error, jacobian;

  LinearizedEdge(const detail::EdgePool& pool, std::uint32_t edge, bool numeric)
      : shape(pool.shape(edge)),
        error(static_cast<std::size_t>(shape.rows)),
        jacobian(static_cast<std::size_t>(shape.rows * shape.cols)) {
    detail::EdgeTile tile;
    tile.error = error.data();
    tile.jacobian = jacobian.data();
    pool.linearize(std::span(&edge, 1), tile, numeric);
  }
};

/// ρ(eᵀΩe).
constexpr auto chi2_of = [](const detail::EdgePool& pool, std::uint32_t edge) {
  double value = 0;
  pool.chi2(std::span(&edge, 1), &value);
  return value;
};

/// The trace of JᵀΩJ.
double curvature_of(const detail::EdgePool& pool, std::uint32_t edge, bool numeric) {
  const LinearizedEdge linearized(pool, edge, numeric);
  double trace = 0;
  for (int k = 0; k < linearized.shape.cols; ++k)
    trace += pool.information(edge, linearized.shape.rows)
                 .squared_norm(linearized.jacobian.data() + k * linearized.shape.rows);
  return trace;
}

}  // namespace

std::string edge_text(const Graph& graph, const EdgeRef& edge) {
  std::string text = "the edge " + std::string(graph.edge_pools()[edge.pool]->type_name());
  text += " between vertices";
  for (const VertexRef& vertex : graph.vertices(edge)) text += " " + std::to_string(graph.id(vertex));
  return text;
}

std::optional<EdgeRef> find_non_finite_error(const Graph& graph, const Plan& plan) {
  return find_edge(graph, plan, [](const detail::EdgePool& pool, std::uint32_t edge) {
    return !std::isfinite(chi2_of(pool, edge));
  });
}

std::optional<EdgeRef> find_non_finite_jacobian(const Graph& graph, const Plan& plan,
                                                const LinearizeOptions& options) {
  return find_edge(graph, plan, [&](const detail::EdgePool& pool, std::uint32_t edge) {
    const LinearizedEdge linearized(pool, edge, options.numeric_jacobians);
    const double e2 = pool.information(edge, linearized.shape.rows).squared_norm(linearized.error.data());
    const double weight = edge_weight(pool.kernel(edge), e2, false).first;
    return !all_finite(linearized.jacobian) || !all_finite(linearized.error) || !std::isfinite(weight);
  });
}

std::string describe_non_finite(const Graph& graph, const Plan& plan, const LinearizeOptions& options,
                                double chi2) {
  if (const auto edge = find_non_finite_error(graph, plan))
    return "the error (or its robust kernel) of " + edge_text(graph, *edge) + " is NaN or infinite";
  if (const auto edge = find_non_finite_jacobian(graph, plan, options))
    return "a Jacobian (or the weight of the robust kernel) of " + edge_text(graph, *edge) +
           " is NaN or infinite";
  if (!std::isfinite(chi2))
    return "chi2 overflows; the largest part comes from " +
           edge_text(graph, largest_edge(graph, plan, chi2_of));
  const auto curvature = [&](const detail::EdgePool& pool, std::uint32_t edge) {
    return curvature_of(pool, edge, options.numeric_jacobians);
  };
  return "the linear system overflows; the largest Jacobian belongs to " +
         edge_text(graph, largest_edge(graph, plan, curvature));
}

}  // namespace boxplus
