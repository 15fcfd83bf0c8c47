// SPDX-License-Identifier: BSD-3-Clause
// Small systems for the tests of linear/.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "boxplus/linear/block_system.h"

namespace boxplus {

/// A symmetric matrix of sparse blocks: its structure and its values.
struct TestSystem {
  BlockStructure structure;
  std::vector<double> values;

  TestSystem(const std::vector<std::uint32_t>& dims, const std::vector<BlockCoordinate>& lower)
      : structure(make_block_structure(dims, lower)), values(structure.nonzero_values(), 0.0) {}

  AssembledSystem view() const { return AssembledSystem(structure, values); }

  Eigen::Map<Eigen::MatrixXd> block(std::uint32_t row, std::uint32_t column) {
    const std::uint32_t k = structure.find(row, column);
    return {values.data() + structure.value_start[k], structure.dim(row), structure.dim(column)};
  }

  /// Adds JᵀJ of one edge. Its Jacobians are `a` for block i and `b` for block j ≠ i.
  void add_edge(std::uint32_t i, std::uint32_t j, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    block(i, i) += a.transpose() * a;
    block(j, j) += b.transpose() * b;
    if (i > j) {
      block(i, j) += a.transpose() * b;
    } else {
      block(j, i) += b.transpose() * a;
    }
  }

  void add_to_diagonal(double value) {
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) block(j, j).diagonal().array() += value;
  }

  Eigen::MatrixXd dense() {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(structure.scalars(), structure.scalars());
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
      for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
        const std::uint32_t i = structure.row[k], r = structure.offset[i], c = structure.offset[j];
        full.block(r, c, structure.dim(i), structure.dim(j)) = block(i, j);
        full.block(c, r, structure.dim(j), structure.dim(i)) = block(i, j).transpose();
      }
    }
    return full;
  }
};

inline std::vector<BlockCoordinate> chain_edges(std::uint32_t blocks) {
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t j = 0; j + 1 < blocks; ++j) edges.push_back({j + 1, j});
  return edges;
}

/// A cube of side³ blocks. Each block is connected to its neighbors (at most six).
inline BlockStructure cube(std::uint32_t side, std::uint32_t dim) {
  std::vector<BlockCoordinate> edges;
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (x * side + y) * side + z;
  };
  for (std::uint32_t x = 0; x < side; ++x) {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t z = 0; z < side; ++z) {
        if (x > 0) edges.push_back({at(x, y, z), at(x - 1, y, z)});
        if (y > 0) edges.push_back({at(x, y, z), at(x, y - 1, z)});
        if (z > 0) edges.push_back({at(x, y, z), at(x, y, z - 1)});
      }
    }
  }
  return make_block_structure(std::vector<std::uint32_t>(side * side * side, dim), edges);
}

inline std::vector<BlockCoordinate> grid_edges(std::uint32_t height, std::uint32_t width) {
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t i = 0; i < height; ++i) {
    for (std::uint32_t j = 0; j < width; ++j) {
      const std::uint32_t id = i * width + j;
      if (j + 1 < width) edges.push_back({id + 1, id});
      if (i + 1 < height) edges.push_back({id + width, id});
    }
  }
  return edges;
}

/// The edges of a chain with some gaps, plus random loop closures.
inline std::vector<BlockCoordinate> random_edges(std::uint32_t blocks, std::uint32_t loops,
                                                 std::mt19937& random) {
  std::vector<BlockCoordinate> edges;
  for (const auto& edge : chain_edges(blocks)) {
    if (random() % 10 != 0) edges.push_back(edge);
  }
  for (std::uint32_t l = 0; l < loops && blocks > 1; ++l) {
    const auto i = static_cast<std::uint32_t>(random() % blocks),
               j = static_cast<std::uint32_t>(random() % blocks);
    if (i != j) edges.push_back({std::max(i, j), std::min(i, j)});
  }
  return edges;
}

inline std::vector<std::uint32_t> random_dims(std::uint32_t blocks, std::mt19937& random) {
  static constexpr std::uint32_t kDims[] = {1, 2, 3, 4, 6, 7, 9, 15};
  std::vector<std::uint32_t> dims;
  for (std::uint32_t i = 0; i < blocks; ++i) dims.push_back(kDims[random() % 8]);
  return dims;
}

inline Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd matrix(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) matrix(i, j) = uniform(random);
  }
  return matrix;
}

/// The sum of JᵀJ over all edges, with random Jacobians J, plus `prior` on the diagonal.
inline TestSystem random_system(const std::vector<std::uint32_t>& dims,
                                const std::vector<BlockCoordinate>& edges, std::mt19937& random,
                                double prior = 0.5) {
  TestSystem system(dims, edges);
  for (const auto& edge : edges) {
    const auto rows = static_cast<Eigen::Index>(std::max(dims[edge.row], dims[edge.column]));
    system.add_edge(edge.row, edge.column, random_matrix(rows, dims[edge.row], random),
                    random_matrix(rows, dims[edge.column], random));
  }
  system.add_to_diagonal(prior);
  return system;
}

inline TestSystem random_system(std::uint32_t blocks, std::uint32_t loops, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto dims = random_dims(blocks, random);
  return random_system(dims, random_edges(blocks, loops, random), random);
}

}  // namespace boxplus
