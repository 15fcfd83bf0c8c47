// SPDX-License-Identifier: BSD-3-Clause
// Covariances and predictions from the live factor as it is.
#pragma once

#include <optional>
#include <span>

#include "boxplus/base/matrix.h"
#include "incremental/live_problem.h"

namespace boxplus {

/// Smoother::covariance(), for a factor that is up to date. Throws InvalidArgument if a vertex takes no part,
/// or has not been factorized yet.
Eigen::MatrixXd joint_covariance(const Graph& graph, LiveProblem& problem,
                                 std::span<const VertexRef> vertices);

/// Smoother::preview(), for a factor that is up to date. Throws what joint_covariance() throws.
EdgePreview preview_edge(const Graph& graph, LiveProblem& problem, EdgeRef edge);

/// If the edge joins a part of the graph with another one, or with the world, and nothing but a held vertex
/// anchors this part, returns the vertex: the edge may move the part, and then costs nothing.
std::optional<detail::GaugeVertex> free_part_of(const Graph& graph, const LiveProblem& problem, EdgeRef edge);

}  // namespace boxplus
