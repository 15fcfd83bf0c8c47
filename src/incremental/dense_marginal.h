// SPDX-License-Identifier: BSD-3-Clause
// A dense quadratic model of some vertices, from which vertices are eliminated.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

/// δᵀHδ + 2 bᵀδ, where δ stacks the tangents of the vertices.
struct DenseModel {
  std::vector<VertexRef> vertices;
  std::vector<Eigen::Index> offset{0};  ///< of each vertex in δ, and the size of δ
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
  Eigen::VectorXd scale;  ///< after eliminated(): the diagonal of H before, which tells rounding errors

  /// Sorts the vertices that are not in `first` by pool and slot, and puts those of `first` before them.
  void set_vertices(const Graph& graph, std::span<const VertexRef> first, std::vector<VertexRef> others);
  /// The position of a vertex, or -1.
  Eigen::Index find(VertexRef vertex) const;
  /// The first entry of a vertex in δ.
  Eigen::Index first_of(VertexRef vertex) const { return offset[find(vertex)]; }
};

/// 1/√d of each entry, with which H gets a unit diagonal; 0 if an entry is not positive.
Eigen::VectorXd unit_scale(const Eigen::VectorXd& diagonal);

/// Eliminates the first `count` vertices (the Schur complement). Directions of them in which H is zero are
/// left out.
DenseModel eliminated(const DenseModel& model, std::size_t count);

/// Adds the prior with this model to the graph. `means` has a pool for each vertex pool of the graph, with
/// the points at which the model holds.
EdgeRef add_marginal_prior(Graph& graph, const DenseModel& model,
                           std::span<const std::unique_ptr<detail::VertexPool>> means);

}  // namespace boxplus
