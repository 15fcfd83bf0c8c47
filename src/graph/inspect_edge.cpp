// SPDX-License-Identifier: BSD-3-Clause
// The error, weight and Jacobian of one edge at the current estimates.
#include "boxplus/graph/graph.h"

namespace boxplus {

double Graph::chi2(EdgeRef edge) const {
  check(edge);
  double result = 0;
  pools_.edges[edge.pool]->chi2(std::span(&edge.slot, 1), &result);
  return result;
}

std::vector<double> Graph::error(EdgeRef edge) const {
  check(edge);
  const detail::EdgePool& pool = *pools_.edges[edge.pool];
  std::vector<double> result(static_cast<std::size_t>(pool.shape(edge.slot).rows));
  pool.errors(std::span(&edge.slot, 1), result.data());
  return result;
}

double Graph::weight(EdgeRef edge) const {
  if (!is_enabled(edge)) return 0;
  const RobustKernel* kernel = pools_.edges[edge.pool]->kernel(edge.slot);
  if (kernel == nullptr) return 1;
  const double first = (*kernel)(chi2(edge)).first;
  return first < 0 ? 0 : first;
}

std::vector<double> Graph::stacked_jacobian(EdgeRef edge) const {
  check(edge);
  const detail::EdgePool& pool = *pools_.edges[edge.pool];
  const detail::EdgeShape shape = pool.shape(edge.slot);
  std::vector<double> error(static_cast<std::size_t>(shape.rows));
  std::vector<double> jacobian(static_cast<std::size_t>(shape.rows) * static_cast<std::size_t>(shape.cols));
  detail::EdgeTile tile;
  tile.error = error.data();
  tile.jacobian = jacobian.data();
  pool.linearize(std::span(&edge.slot, 1), tile, false);
  return jacobian;
}

}  // namespace boxplus
