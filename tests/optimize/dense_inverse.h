// SPDX-License-Identifier: BSD-3-Clause
// An independent, dense and slow covariance.
#pragma once

#include <Eigen/LU>
#include <map>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// The dense inverse of H = Σ w JᵀΩJ. H is summed edge by edge from Graph::jacobian() and Graph::weight(),
/// without the linearizer and the linear solvers.
class DenseInverse {
 public:
  DenseInverse(const Graph& graph, const std::vector<VertexRef>& moving, int level = 0) {
    Eigen::Index size = 0;
    for (const VertexRef& vertex : moving) {
      first_[vertex] = size;
      size += graph.tangent_dim(vertex);
    }
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
    for (const EdgeRef& edge : graph.all_edges()) {
      if (graph.level(edge) == level) add(graph, edge, H);
    }
    inverse_ = H.fullPivLu().inverse();
  }

  Eigen::MatrixXd of(const Graph& graph, VertexRef a, VertexRef b) const {
    const int rows = graph.tangent_dim(a), columns = graph.tangent_dim(b);
    if (!first_.contains(a) || !first_.contains(b)) return Eigen::MatrixXd::Zero(rows, columns);
    return inverse_.block(first_.at(a), first_.at(b), rows, columns);
  }

 private:
  void add(const Graph& graph, EdgeRef edge, Eigen::MatrixXd& H) const {
    const std::vector<VertexRef> vertices = graph.vertices(edge);
    const std::vector<Eigen::MatrixXd> J = graph.jacobian(edge);
    const Eigen::MatrixXd Omega = graph.weight(edge) * graph.information(edge).matrix();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (std::size_t j = 0; j < vertices.size(); ++j) {
        if (!first_.contains(vertices[i]) || !first_.contains(vertices[j])) continue;
        H.block(first_.at(vertices[i]), first_.at(vertices[j]), J[i].cols(), J[j].cols()) +=
            J[i].transpose() * Omega * J[j];
      }
    }
  }

  std::map<VertexRef, Eigen::Index> first_;
  Eigen::MatrixXd inverse_;
};

}  // namespace boxplus
