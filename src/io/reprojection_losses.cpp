// SPDX-License-Identifier: BSD-3-Clause
#include "io/reprojection_losses.h"

#include <fmt/format.h>

#include <cstddef>
#include <map>

namespace boxplus {
namespace {

bool is_identity(const Information::View& omega) {
  for (int i = 0; i < omega.rows; ++i) {
    for (int j = 0; j < omega.rows; ++j) {
      if (omega(i, j) != (i == j ? 1 : 0)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::string> reprojection_losses(const Graph& graph,
                                             detail::FunctionRef<bool(EdgeRef)> is_reprojection) {
  std::size_t weighted = 0;
  std::map<std::string_view, std::size_t> others;  // by the type of the edge
  for (const EdgeRef& edge : graph.all_edges()) {
    if (!is_reprojection(edge))
      ++others[graph.edge_pools()[edge.pool]->type_name()];
    else if (!is_identity(graph.information(edge)))
      ++weighted;
  }
  std::vector<std::string> sentences;
  if (weighted > 0)
    sentences.push_back(fmt::format("the information of {} edge{}", weighted, weighted == 1 ? "" : "s"));
  for (const auto& [type, count] : others)
    sentences.push_back(fmt::format("{} edge{} {}", count, count == 1 ? "" : "s", type));
  return sentences;
}

}  // namespace boxplus
