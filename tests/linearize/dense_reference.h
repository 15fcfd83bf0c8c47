// SPDX-License-Identifier: BSD-3-Clause
// Computes a dense H and gradient by the textbook formulas, edge by edge, without the index maps of the
// linearizer.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <vector>

#include "linearize/linearizer.h"

namespace boxplus {

struct DenseSystem {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

/// A symmetric matrix of sparse blocks as a dense matrix.
inline Eigen::MatrixXd dense_matrix(const BlockStructure& structure, std::span<const double> values) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(structure.scalars(), structure.scalars());
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    for (std::uint32_t k = structure.column_start[column]; k < structure.column_start[column + 1]; ++k) {
      const std::uint32_t row = structure.row[k];
      const Eigen::Map<const Eigen::MatrixXd> block(values.data() + structure.value_start[k],
                                                    structure.dim(row), structure.dim(column));
      dense.block(structure.offset[row], structure.offset[column], block.rows(), block.cols()) = block;
      dense.block(structure.offset[column], structure.offset[row], block.cols(), block.rows()) =
          block.transpose();
    }
  }
  return dense;
}

/// The error, the Jacobian (with the columns of all vertices) and the Ω of one edge.
struct DenseEdge {
  Eigen::VectorXd error;
  Eigen::MatrixXd jacobian, omega;

  DenseEdge(const detail::EdgePool& pool, std::uint32_t edge) {
    const detail::EdgeShape shape = pool.shape(edge);
    error.resize(shape.rows);
    jacobian.resize(shape.rows, shape.cols);
    detail::EdgeTile tile;
    tile.error = error.data();
    tile.jacobian = jacobian.data();
    pool.linearize(std::span(&edge, 1), tile, false);
    omega = pool.information(edge).matrix();
  }
};

/// The Ω of an edge with the weight of its kernel: ρ′Ω. With Triggs' correction, it is ρ′Ω + 2ρ″ Ωe eᵀΩ, and
/// the curvature along e is at least 1e-4 of that of ρ′Ω. There is no correction where ρ is concave along e.
inline Eigen::MatrixXd weighted_information(const DenseEdge& edge, const RobustKernel* kernel, bool triggs) {
  if (kernel == nullptr) return edge.omega;
  const Eigen::VectorXd omega_e = edge.omega * edge.error;
  const double e2 = edge.error.dot(omega_e);
  const RobustKernel::Rho rho = (*kernel)(e2);
  const double first = std::max(0.0, rho.first);
  Eigen::MatrixXd weighted = first * edge.omega;
  const double along_error = first + 2 * rho.second * e2;
  if (triggs && e2 > 0 && along_error > -1e-9 * first)
    weighted += (std::max(along_error, 1e-4 * first) - first) / e2 * omega_e * omega_e.transpose();
  return weighted;
}

/// The first scalar of each block of the plan, by the pool and slot of its vertex. Fixed vertices are absent.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> block_offsets(const Plan& plan) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> offsets;
  for (std::uint32_t block = 0; block < plan.block_vertex.size(); ++block) {
    offsets[{plan.block_vertex[block].pool, plan.block_vertex[block].slot}] = plan.structure.offset[block];
  }
  return offsets;
}

/// H and the gradient, summed over all enabled edges of the plan. The order of the unknowns is the order of
/// the plan.
inline DenseSystem dense_reference(const Graph& graph, const Plan& plan, bool triggs = false) {
  const auto n = static_cast<Eigen::Index>(plan.scalars());
  DenseSystem system{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  const auto offsets = block_offsets(plan);
  for (const EdgeList& list : plan.edges) {
    for (const std::uint32_t slot : list.edges) {
      const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
      if (!pool.enabled(slot)) continue;
      const DenseEdge edge(pool, slot);
      Eigen::MatrixXd J = Eigen::MatrixXd::Zero(edge.error.size(), n);
      Eigen::Index column = 0;
      for (const VertexRef& v : graph.vertices({list.pool, slot, pool.generation(slot)})) {
        const int dim = graph.tangent_dim(v);
        const auto offset = offsets.find({v.pool, v.slot});
        if (offset != offsets.end())
          J.middleCols(offset->second, dim) = edge.jacobian.middleCols(column, dim);
        column += dim;
      }
      const RobustKernel* kernel = pool.kernel(slot);
      const double e2 = edge.error.dot(edge.omega * edge.error);
      const double first = kernel ? std::max(0.0, (*kernel)(e2).first) : 1;
      system.hessian += J.transpose() * weighted_information(edge, kernel, triggs) * J;
      system.gradient += first * J.transpose() * edge.omega * edge.error;
    }
  }
  return system;
}

/// Compares H and the gradient of the linearizer with the dense reference.
inline void expect_equals_reference(const Graph& graph, const Plan& plan,
                                    const LinearizeOptions& options = {}) {
  Linearizer linearizer(graph, plan);
  linearizer.linearize(options);
  const DenseSystem expected = dense_reference(graph, plan, options.triggs_correction);
  const Eigen::MatrixXd hessian = dense_matrix(plan.structure, linearizer.values());
  const auto gradient = Eigen::Map<const Eigen::VectorXd>(linearizer.gradient().data(), plan.scalars());
  EXPECT_LE((hessian - expected.hessian).norm(), 1e-12 * (1 + expected.hessian.norm()));
  EXPECT_LE((gradient - expected.gradient).norm(), 1e-12 * (1 + expected.gradient.norm()));
  EXPECT_LE((hessian - hessian.transpose()).norm(), 1e-13 * hessian.norm());
}

}  // namespace boxplus
