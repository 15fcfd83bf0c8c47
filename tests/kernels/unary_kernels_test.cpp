// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "kernels/every_isa.h"
#include "kernels/kernel_table.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using dense::EdgeNumbers;
using Matrix = Eigen::MatrixXd;

/// Random unary edges at two vertices: three edges at the first vertex, three edges at the second vertex,
/// three at the first again, and so on. Every seventh edge has a fixed vertex instead.
struct Edges {
  Edges(int count, int rows_in, int dim_in, EdgeNumbers::Kind kind, std::mt19937& random)
      : rows(rows_in), dim(dim_in) {
    for (int k = 0; k < count; ++k) {
      const Matrix J = random_matrix(rows, dim, random), e = random_matrix(rows, 1, random);
      jacobian.insert(jacobian.end(), J.data(), J.data() + J.size());
      error.insert(error.end(), e.data(), e.data() + e.size());
      weight.push_back(0.5 + k);
      const Matrix root = random_matrix(rows, rows, random), full = root * root.transpose();
      Matrix Omega = Matrix::Zero(rows, rows);
      numbers.emplace_back();
      for (int i = 0; i < rows; ++i) {
        for (int j = i; j < rows; ++j) {
          if (kind != EdgeNumbers::kFull && i != j) continue;
          Omega(i, j) = Omega(j, i) = kind == EdgeNumbers::kScalar ? full(0, 0) : full(i, j);
          if (kind != EdgeNumbers::kScalar || i == 0) numbers.back().push_back(Omega(i, j));
        }
      }
      omegas.push_back(Omega);
      const auto at = static_cast<std::uint32_t>(k / 3 % 2);
      const auto size = static_cast<std::uint32_t>(dim);
      target.push_back(k % 7 == 6 ? std::array{dense::kNoTarget, dense::kNoTarget}
                                  : std::array{at * size, at * size * size});
    }
    for (const auto& n : numbers) omega.push_back(n.data());
    for (const auto& t : target) targets.push_back(t.data());
  }

  /// Adds the contributions of `count` edges, from the edge `first` on, to `values` and `gradient`.
  void add(std::size_t first, int count, EdgeNumbers::Kind kind, bool is_weighted, Matrix& values,
           Matrix& gradient) const {
    dense::kernels().add_unary_edges_for(
        rows, dim)({count, &jacobian[first * static_cast<std::size_t>(rows * dim)],
                    &error[first * static_cast<std::size_t>(rows)], kind, &omega[first],
                    is_weighted ? &weight[first] : nullptr, &targets[first], values.data(), gradient.data()});
  }

  int rows, dim;
  std::vector<double> jacobian, error, weight;
  std::vector<Matrix> omegas;
  std::vector<std::vector<double>> numbers;
  std::vector<const double*> omega;
  std::vector<std::array<std::uint32_t, 2>> target;
  std::vector<const std::uint32_t*> targets;
};

template <class F>
void for_each_case(F&& f) {
  for (const int rows : {1, 2, 3}) {
    for (const int dim : {1, 2, 3, 4, 6, 7}) {
      for (const auto kind : {EdgeNumbers::kScalar, EdgeNumbers::kDiagonal, EdgeNumbers::kFull}) {
        for (const bool is_weighted : {false, true}) f(rows, dim, kind, is_weighted);
      }
    }
  }
}

class UnaryKernels : public EveryIsa {};

TEST_P(UnaryKernels, AddTheValuesOfTheFormulaToTheTargets) {
  std::mt19937 random(1);
  constexpr int kCount = 17;
  for_each_case([&](int rows, int dim, EdgeNumbers::Kind kind, bool is_weighted) {
    const Edges edges(kCount, rows, dim, kind, random);
    Matrix values = random_matrix(2 * dim * dim + 1, 1, random),
           gradient = random_matrix(2 * dim + 1, 1, random);
    Matrix expected = values, expected_gradient = gradient;
    edges.add(0, kCount, kind, is_weighted, values, gradient);
    for (int k = 0; k < kCount; ++k) {
      if (edges.targets[k][0] == dense::kNoTarget) continue;
      const Eigen::Map<const Matrix> J(&edges.jacobian[static_cast<std::size_t>(k * rows * dim)], rows, dim),
          e(&edges.error[static_cast<std::size_t>(k * rows)], rows, 1);
      const Matrix weighted = (is_weighted ? edges.weight[k] : 1) * edges.omegas[k] * J;
      expected.block(edges.targets[k][1], 0, dim * dim, 1) += (J.transpose() * weighted).reshaped();
      expected_gradient.block(edges.targets[k][0], 0, dim, 1) += weighted.transpose() * e;
    }
    EXPECT_LE((values - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
    EXPECT_LE((gradient - expected_gradient).cwiseAbs().maxCoeff(),
              1e-12 * expected_gradient.cwiseAbs().maxCoeff());
  });
}

TEST_P(UnaryKernels, AddTheSameBitsForOneEdgeAtATimeAndForAllEdgesAtOnce) {
  std::mt19937 random(2);
  constexpr int kCount = 17;
  for_each_case([&](int rows, int dim, EdgeNumbers::Kind kind, bool is_weighted) {
    const Edges edges(kCount, rows, dim, kind, random);
    Matrix together = Matrix::Zero(2 * dim * dim, 1), gradient = Matrix::Zero(2 * dim, 1);
    Matrix alone = together, gradient_alone = gradient;
    edges.add(0, kCount, kind, is_weighted, together, gradient);
    for (std::size_t k = 0; k < kCount; ++k) edges.add(k, 1, kind, is_weighted, alone, gradient_alone);
    EXPECT_EQ(together, alone);
    EXPECT_EQ(gradient, gradient_alone);
  });
}

TEST_P(UnaryKernels, DoNotExistForUncommonSizes) {
  EXPECT_EQ(dense::kernels().add_unary_edges_for(4, 6), nullptr);
  EXPECT_EQ(dense::kernels().add_unary_edges_for(1, 5), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Isa, UnaryKernels, ::testing::ValuesIn(dense::usable_kernels()), name_of_isa);

}  // namespace
}  // namespace boxplus
