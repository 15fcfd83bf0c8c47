// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "kernels/every_isa.h"
#include "kernels/kernel_table.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using dense::EdgeNumbers;
using Matrix = Eigen::MatrixXd;

/// Random binary edges: their Jacobians, errors, weights and information matrices.
struct Edges {
  Edges(int count, int rows, int dim_i, int dim_j, EdgeNumbers::Kind kind, std::mt19937& random)
      : dim{dim_i, dim_j} {
    for (int k = 0; k < count; ++k) {
      jacobians.push_back(random_matrix(rows, dim_i + dim_j, random));
      errors.push_back(random_matrix(rows, 1, random));
      weights.push_back(0.5 + k);
      const Matrix root = random_matrix(rows, rows, random), full = root * root.transpose();
      omegas.push_back(Matrix::Zero(rows, rows));
      numbers.emplace_back();
      for (int i = 0; i < rows; ++i) {
        for (int j = i; j < rows; ++j) {
          if (kind != EdgeNumbers::kFull && i != j) continue;
          omegas[k](i, j) = omegas[k](j, i) = kind == EdgeNumbers::kScalar ? full(0, 0) : full(i, j);
          if (kind != EdgeNumbers::kScalar || i == 0) numbers[k].push_back(omegas[k](i, j));
        }
      }
    }
    for (const auto& n : numbers) omega.push_back(n.data());
  }

  std::vector<double> in_lanes(const std::vector<Matrix>& blocks) const {
    const auto size = static_cast<std::size_t>(blocks[0].size());
    std::vector<double> edges;
    for (const Matrix& block : blocks) edges.insert(edges.end(), block.data(), block.data() + size);
    const std::size_t tiles = (blocks.size() + dense::kTileLanes - 1) / dense::kTileLanes;
    std::vector<double> lanes(tiles * size * dense::kTileLanes);
    dense::kernels().to_lanes(edges.data(), static_cast<int>(size), static_cast<int>(blocks.size()),
                              lanes.data());
    return lanes;
  }

  int dim[2];
  std::vector<Matrix> jacobians, errors, omegas;
  std::vector<double> weights;
  std::vector<std::vector<double>> numbers;
  std::vector<const double*> omega;
};

dense::AddEdges add_edges_for(int rows, const std::vector<int>& dims) {
  return dense::kernels().add_edges_for(rows, dims.data(), static_cast<int>(dims.size()));
}

class EdgeLanes : public EveryIsa {};

TEST_P(EdgeLanes, StoreTheValuesOfEachEdgeInItsOwnLane) {
  for (int size = 1; size <= 80; ++size) {
    for (const int count : {1, 2, 7, 8, 9, 16, 21}) {
      std::vector<double> edges(static_cast<std::size_t>(size * count));
      for (std::size_t n = 0; n < edges.size(); ++n) edges[n] = static_cast<double>(n);
      const int tiles = (count + dense::kTileLanes - 1) / dense::kTileLanes;
      std::vector<double> lanes(static_cast<std::size_t>(tiles * size * dense::kTileLanes), -1);
      dense::kernels().to_lanes(edges.data(), size, count, lanes.data());
      // The kernel may leave unused lanes unchanged, so only used lanes are checked.
      for (int k = 0; k < count; ++k) {
        for (int m = 0; m < size; ++m) {
          const int at = ((k / dense::kTileLanes) * size + m) * dense::kTileLanes + k % dense::kTileLanes;
          ASSERT_EQ(lanes[static_cast<std::size_t>(at)], k * size + m);
        }
      }
    }
  }
}

TEST_P(EdgeLanes, AddTheValuesOfTheFormulaToTheTargets) {
  std::mt19937 random(1);
  constexpr int kSizes[][3] = {{3, 3, 3},  {6, 6, 6},  {2, 3, 2},  {3, 6, 3},  {2, 6, 3},  {2, 9, 3},
                               {2, 10, 3}, {2, 11, 3}, {2, 12, 3}, {2, 14, 3}, {2, 18, 3}, {2, 22, 3}};
  for (const auto& [rows, dim_i, dim_j] : kSizes) {
    const dense::AddEdges add_edges = add_edges_for(rows, {dim_i, dim_j});
    ASSERT_NE(add_edges, nullptr);
    for (const auto kind : {EdgeNumbers::kScalar, EdgeNumbers::kDiagonal, EdgeNumbers::kFull}) {
      for (const int count : {1, 3, 8, 9, 17}) {
        for (const bool is_weighted : {false, true}) {
          const Edges edges(count, rows, dim_i, dim_j, kind, random);
          // The gradient of vertex j follows the gradient of vertex i. Every third edge stores its
          // off-diagonal block transposed. In every fifth edge, vertex j is fixed.
          const auto ii = static_cast<std::uint32_t>(dim_i * dim_i),
                     ij = static_cast<std::uint32_t>(dim_i * dim_j),
                     jj = static_cast<std::uint32_t>(dim_j * dim_j);
          std::vector<std::uint32_t> targets;
          for (int k = 0; k < count; ++k) {
            const bool fixed = k % 5 == 4, transposed = k % 3 == 1;
            const std::uint32_t none = dense::kNoTarget;
            targets.insert(targets.end(),
                           {0, fixed ? none : static_cast<std::uint32_t>(dim_i), 0,
                            fixed ? none : (transposed ? (ii + ij) | dense::kTransposedTarget : ii),
                            fixed ? none : ii + 2 * ij});
          }
          std::vector<const std::uint32_t*> target_of;
          for (int k = 0; k < count; ++k) target_of.push_back(&targets[k * 5]);
          const Matrix start = random_matrix(static_cast<int>(ii + 2 * ij + jj) + 1, 1, random);
          Matrix values = start, gradient = random_matrix(dim_i + dim_j + 1, 1, random);
          const Matrix gradient_start = gradient;
          const auto jacobian = edges.in_lanes(edges.jacobians), error = edges.in_lanes(edges.errors);
          add_edges({count, jacobian.data(), error.data(), kind, edges.omega.data(),
                     is_weighted ? edges.weights.data() : nullptr, target_of.data(), values.data(),
                     gradient.data()});

          Matrix h_ii = Matrix::Zero(dim_i, dim_i), h_ji = Matrix::Zero(dim_j, dim_i),
                 h_ij = h_ji.transpose(), h_jj = Matrix::Zero(dim_j, dim_j),
                 g = Matrix::Zero(dim_i + dim_j + 1, 1);
          for (int k = 0; k < count; ++k) {
            const double weight = is_weighted ? edges.weights[k] : 1;
            const Matrix h = weight * edges.jacobians[k].transpose() * edges.omegas[k] * edges.jacobians[k];
            Matrix b = weight * edges.jacobians[k].transpose() * edges.omegas[k] * edges.errors[k];
            if (k % 5 == 4) b.bottomRows(dim_j).setZero();
            g.topRows(dim_i + dim_j) += b;
            h_ii += h.topLeftCorner(dim_i, dim_i);
            if (k % 5 == 4) continue;
            (k % 3 == 1 ? h_ij : h_ji) +=
                k % 3 == 1 ? h.topRightCorner(dim_i, dim_j).eval() : h.bottomLeftCorner(dim_j, dim_i).eval();
            h_jj += h.bottomRightCorner(dim_j, dim_j);
          }
          Matrix expected = start;
          Eigen::VectorXd blocks(ii + 2 * ij + jj);
          blocks << h_ii.reshaped(), h_ji.reshaped(), h_ij.reshaped(), h_jj.reshaped();
          expected.topRows(blocks.size()) += blocks;
          const double scale = 1e-12 * (1 + expected.cwiseAbs().maxCoeff());
          EXPECT_LE((values - expected).cwiseAbs().maxCoeff(), scale) << rows << dim_i << dim_j << count;
          EXPECT_LE((gradient - gradient_start - g).cwiseAbs().maxCoeff(), scale);
        }
      }
    }
  }
}

/// Compares edges with a pose, a point and a camera of `dim` parameters with the formula.
void expect_every_block_with_camera(int dim) {
  std::mt19937 random(4);
  const int dims[] = {6, 3, dim}, first[] = {0, 6, 9}, columns = 9 + dim;
  const auto block_size = static_cast<std::size_t>(std::max(6, dim) * std::max(6, dim));
  const dense::AddEdges add_edges = add_edges_for(2, {6, 3, dim});
  ASSERT_NE(add_edges, nullptr);
  constexpr int kCount = 11;
  const Edges edges(kCount, 2, 6, 3 + dim, EdgeNumbers::kFull, random);
  const auto jacobian = edges.in_lanes(edges.jacobians), error = edges.in_lanes(edges.errors);
  for (const bool transposed : {false, true}) {
    std::vector<std::uint32_t> targets{0, 6, 9};
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        const std::uint32_t flag = transposed && j < i ? dense::kTransposedTarget : 0;
        targets.push_back(static_cast<std::uint32_t>(block_size * pairs.size()) | flag);
        pairs.emplace_back(i, j);
      }
    }
    const std::vector<const std::uint32_t*> target_of(kCount, targets.data());
    std::vector<double> values(block_size * pairs.size()), gradient(static_cast<std::size_t>(columns));
    add_edges({kCount, jacobian.data(), error.data(), EdgeNumbers::kFull, edges.omega.data(), nullptr,
               target_of.data(), values.data(), gradient.data()});
    Matrix h = Matrix::Zero(columns, columns), g = Matrix::Zero(columns, 1);
    for (std::size_t k = 0; k < kCount; ++k) {
      h += edges.jacobians[k].transpose() * edges.omegas[k] * edges.jacobians[k];
      g += edges.jacobians[k].transpose() * edges.omegas[k] * edges.errors[k];
    }
    EXPECT_LE((Eigen::Map<Matrix>(gradient.data(), columns, 1) - g).cwiseAbs().maxCoeff(), 1e-12);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      auto [i, j] = pairs[k];
      if (transposed && j < i) std::swap(i, j);
      const Matrix expected = h.block(first[i], first[j], dims[i], dims[j]);
      const Eigen::Map<Matrix> block(&values[block_size * k], dims[i], dims[j]);
      EXPECT_LE((block - expected).cwiseAbs().maxCoeff(), 1e-12) << i << ' ' << j << ' ' << dim;
    }
  }
}

TEST_P(EdgeLanes, AddEveryBlockOfAnEdgeWithThreeVertices) {
  for (const int dim : {3, 4, 5, 6, 8, 12, 16}) expect_every_block_with_camera(dim);
}

TEST_P(EdgeLanes, AddTheSameBitsForAnEdgeWhicheverEdgesShareItsTile) {
  std::mt19937 random(2);
  const Edges edges(13, 6, 6, 6, EdgeNumbers::kFull, random);
  const auto jacobian = edges.in_lanes(edges.jacobians), error = edges.in_lanes(edges.errors);
  const dense::AddEdges add_edges = add_edges_for(6, {6, 6});
  const std::uint32_t target[] = {0, 6, 0, 36, 72};
  const std::vector<const std::uint32_t*> targets(13, target);
  std::vector<double> together(108), gradient(12), alone(108), gradient_alone(12);
  add_edges({13, jacobian.data(), error.data(), EdgeNumbers::kFull, edges.omega.data(), nullptr,
             targets.data(), together.data(), gradient.data()});
  for (std::size_t k = 0; k < 13; ++k) {
    const auto j = edges.in_lanes({edges.jacobians[k]}), e = edges.in_lanes({edges.errors[k]});
    add_edges({1, j.data(), e.data(), EdgeNumbers::kFull, &edges.omega[k], nullptr, targets.data(),
               alone.data(), gradient_alone.data()});
  }
  EXPECT_EQ(together, alone);
  EXPECT_EQ(gradient, gradient_alone);
}

TEST_P(EdgeLanes, ComputeTheSquaredNormsOfErrorsUnderTheirInformation) {
  std::mt19937 random(3);
  for (const int rows : {2, 3, 6}) {
    for (const auto kind : {EdgeNumbers::kScalar, EdgeNumbers::kDiagonal, EdgeNumbers::kFull}) {
      const Edges edges(11, rows, 1, 1, kind, random);
      double chi2[12];
      chi2[11] = -1;
      const dense::SquaredNorms squared_norms = dense::kernels().squared_norms_for(rows);
      squared_norms(11, edges.in_lanes(edges.errors).data(), kind, edges.omega.data(), chi2);
      for (int k = 0; k < 11; ++k) {
        const double expected = (edges.errors[k].transpose() * edges.omegas[k] * edges.errors[k]).value();
        EXPECT_NEAR(chi2[k], expected, 1e-12 * (1 + expected));
      }
      EXPECT_EQ(chi2[11], -1) << "wrote beyond the last edge";
    }
  }
}

TEST_P(EdgeLanes, DoNotExistForUncommonSizes) {
  for (const int rows : {1, 4, 5, 7, 8, 9}) EXPECT_EQ(dense::kernels().squared_norms_for(rows), nullptr);
  EXPECT_EQ(add_edges_for(4, {3, 3}), nullptr);
  EXPECT_EQ(add_edges_for(2, {6, 3, 2}), nullptr);
  EXPECT_EQ(add_edges_for(2, {6, 3, 3, 3}), nullptr);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, EdgeLanes, ::testing::ValuesIn(dense::usable_kernels()),
                         name_of_isa);

}  // namespace
}  // namespace boxplus
