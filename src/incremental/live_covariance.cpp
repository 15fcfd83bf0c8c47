// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/live_covariance.h"

#include <Eigen/LU>
#include <algorithm>
#include <string>
#include <vector>

#include "boxplus/base/error.h"

namespace boxplus {

Eigen::MatrixXd joint_covariance(const Graph& graph, LiveProblem& problem,
                                 std::span<const VertexRef> vertices) {
  std::vector<LiveProblem::Index> blocks;
  std::vector<Eigen::Index> from;  // of each scalar of the result: its place among those of the blocks
  Eigen::Index next = 0;
  for (const VertexRef& vertex : vertices) {
    const LiveProblem::Index block = problem.block(vertex);
    const int dim = graph.tangent_dim(vertex);
    if (!problem.takes_part(vertex))
      throw InvalidArgument("Smoother: vertex " + std::to_string(graph.id(vertex)) + " has no enabled edges");
    if (block != LiveProblem::kNone && problem.factor().root_of(block) == LiveProblem::kNone)
      throw InvalidArgument("Smoother: vertex " + std::to_string(graph.id(vertex)) + " is new");
    for (int i = 0; i < dim; ++i) from.push_back(block == LiveProblem::kNone ? -1 : next++);
    if (block == LiveProblem::kNone) continue;
    for (const int held : problem.factor().held_scalars(block))
      from[from.size() - static_cast<std::size_t>(dim - held)] = -1;
    blocks.push_back(block);
  }
  std::vector<double> values;
  problem.factor().covariance(blocks, values);
  const Eigen::Map<const Eigen::MatrixXd> found(values.data(), next, next);
  const auto size = static_cast<Eigen::Index>(from.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index a = from[i], b = from[j];
      if (a >= 0 && b >= 0) result(i, j) = found(a, b);
    }
  }
  return result;
}

namespace {

using Index = LiveProblem::Index;

/// The root of the part of the graph that a vertex is in, or kNone if it is fixed and has no part.
Index part_of(const Graph& graph, const LiveProblem& problem, VertexRef vertex) {
  if (problem.block(vertex) != LiveProblem::kNone) return problem.factor().root_of(problem.block(vertex));
  if (graph.is_fixed(vertex)) return LiveProblem::kNone;
  for (const EdgeRef& edge : graph.edges(vertex)) {  // of a vertex that is held
    for (const VertexRef& other : graph.vertices(edge)) {
      if (graph.is_enabled(edge) && problem.block(other) != LiveProblem::kNone)
        return problem.factor().root_of(problem.block(other));
    }
  }
  return LiveProblem::kNone;
}

}  // namespace

std::optional<detail::GaugeVertex> free_part_of(const Graph& graph, const LiveProblem& problem,
                                                EdgeRef edge) {
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  std::vector<Index> parts;
  bool reaches_world = vertices.size() == 1;
  for (const VertexRef& vertex : vertices) {
    if (graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) continue;
    const Index part = part_of(graph, problem, vertex);
    reaches_world = reaches_world || graph.is_fixed(vertex);
    if (part != LiveProblem::kNone && std::find(parts.begin(), parts.end(), part) == parts.end())
      parts.push_back(part);
  }
  if (parts.size() + (reaches_world ? 1 : 0) < 2) return std::nullopt;
  for (const detail::GaugeVertex& held : problem.held()) {
    if (std::find(parts.begin(), parts.end(), part_of(graph, problem, held.vertex)) != parts.end())
      return held;
  }
  return std::nullopt;
}

EdgePreview preview_edge(const Graph& graph, LiveProblem& problem, EdgeRef edge) {
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  if (const auto held = free_part_of(graph, problem, edge)) {
    throw InvalidArgument(
        "Smoother: an edge may cost nothing if it joins a part of the graph in which only vertex " +
        std::to_string(held->id) + " is held: expected an edge within one part");
  }
  const Eigen::MatrixXd sigma = joint_covariance(graph, problem, vertices);
  const std::vector<Eigen::MatrixXd> blocks = graph.jacobian(edge);
  const std::vector<double> values = graph.error(edge);
  const Eigen::Map<const Eigen::VectorXd> e(values.data(), static_cast<Eigen::Index>(values.size()));
  Eigen::MatrixXd J(e.size(), sigma.cols());
  Eigen::Index column = 0;
  for (const Eigen::MatrixXd& block : blocks) {
    J.middleCols(column, block.cols()) = block;
    column += block.cols();
  }
  const Eigen::MatrixXd omega = graph.information(edge).matrix();
  // (Ω⁻¹ + C)⁻¹ = (I + ΩC)⁻¹ Ω also exists if Ω is singular.
  const Eigen::MatrixXd C = J * sigma * J.transpose();
  const Eigen::VectorXd weighted =
      (Eigen::MatrixXd::Identity(e.size(), e.size()) + omega * C).partialPivLu().solve(omega * e);
  EdgePreview preview{e.dot(omega * e), e.dot(weighted), static_cast<int>(e.size()), {}};
  const Eigen::VectorXd step = -sigma * J.transpose() * weighted;
  column = 0;
  for (const Eigen::MatrixXd& block : blocks) {
    preview.steps.emplace_back(step.segment(column, block.cols()));
    column += block.cols();
  }
  return preview;
}

}  // namespace boxplus
