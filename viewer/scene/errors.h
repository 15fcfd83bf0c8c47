// SPDX-License-Identifier: BSD-3-Clause
// The errors of the edges of a graph, as they are drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/graph/graph.h"
#include "viewer/scene/structure.h"
#include "viewer/scene/verdicts.h"

namespace boxplus::viewer {

struct Errors {
  /// In bundle adjustment, the root of the mean squared reprojection error of each point, without kernels: in
  /// pixels, or in standard deviations if the edges have an Ω. Empty for other graphs.
  std::vector<float> points;
  /// Per line: eᵀΩe of its edge, without its kernel, divided by the number of rows of e.
  std::vector<float> chi2;
  /// Per line: the weight of its edge from 0 to 1, as Graph::weight(). Empty if all edges that are drawn are
  /// enabled and have no kernel.
  std::vector<float> weights;
  /// As verdicts_of_lines().
  std::vector<std::uint8_t> verdicts;
};

/// Evaluates each edge of `graph` once. The graph must have the structure `structure`.
Errors read_errors(const Graph& graph, const Structure& structure, const Verdicts& verdicts = {});

}  // namespace boxplus::viewer
