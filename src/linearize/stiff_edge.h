// SPDX-License-Identifier: BSD-3-Clause
// Finds edges whose weight in some direction is so large that H, in double, loses other measurements.
#pragma once

#include <optional>

#include "linearize/linearizer.h"

namespace boxplus {

/// A row of an edge is stiff if its weight at a vertex is at least `ratio` times the weight of another row at
/// this vertex. The rows are those of √Ω J; the weight of a row is its squared norm in the columns of the
/// vertex. H is the sum of the products of these rows. In double, it keeps the lighter row with a relative
/// error of about 1e-16 times the ratio.
inline constexpr double kStiffRatio = 1e8;
/// With this ratio, steps in double may be wrong even if the factor loses no pivot.
inline constexpr double kVeryStiffRatio = 1e12;

/// An edge with a stiff row, and the vertex at which it is stiff.
struct StiffEdge {
  EdgeRef edge;
  VertexRef vertex;
};

/// Finds the stiff edge with the largest weight at the current estimates. An edge that determines all
/// directions of a single moving vertex with about the same weight is not stiff, because it only fixes the
/// vertex. Linearizes each edge twice, in one thread.
/// Finds nothing if `stop` is raised.
std::optional<StiffEdge> find_stiff_edge(const Graph& graph, const Plan& plan,
                                         const LinearizeOptions& options, double ratio,
                                         const StopToken& stop = {});

/// Finds an edge whose stored Ω has lost what it says about its light directions: an entry off the diagonal
/// is at least 1e13 times the weight of a row at a vertex of the edge, so that rounding of this entry changes
/// chi2. Not even a step with more digits helps. Linearizes as find_stiff_edge().
std::optional<StiffEdge> find_rounded_edge(const Graph& graph, const Plan& plan,
                                           const LinearizeOptions& options, const StopToken& stop = {});

/// Whether the diagonal entries of all Ω have a ratio of at least kStiffRatio. Large Ω of edges that only fix
/// a vertex do not count. Does not linearize.
bool information_is_stiff(const Graph& graph, const Plan& plan);

}  // namespace boxplus
