// SPDX-License-Identifier: BSD-3-Clause
// Compares the kernels that linearize several Between edges at a time with the functions for one edge.
#include <gtest/gtest.h>

#include <random>

#include "boxplus/boxplus.h"
#include "kernels/every_isa.h"

namespace boxplus {
namespace {

class BetweenLanes : public EveryIsa {
 protected:
  double number(double size) { return std::uniform_real_distribution(-size, size)(random_); }
  SE2 pose(std::type_identity<SE2>) { return {number(10), number(10), number(kPi)}; }
  SE3 pose(std::type_identity<SE3>) {
    return {Vector3(number(10), number(10), number(10)),
            detail::Quaternion<double>{number(1), number(1), number(1), number(1)}};
  }
  Information information(int rows, int kind) {
    if (kind == 0) return 2.5;
    Eigen::MatrixXd root(rows, rows);
    for (double& entry : root.reshaped()) entry = number(1);
    const Eigen::MatrixXd full = root * root.transpose();
    if (kind == 2) return full;
    return Eigen::MatrixXd(full.diagonal().asDiagonal());
  }

  /// Computes errors, Jacobians and chi2 of `count` edges in lanes, and compares them with the results for
  /// each edge alone.
  template <class T>
  void compare(int count, int kinds) {
    constexpr int kDim = Manifold<T>::kDim;
    Graph graph;
    std::vector<VertexHandle<T>> vertices;
    for (int k = 0; k < 5; ++k) vertices.push_back(graph.add_vertex(pose(std::type_identity<T>())));
    std::vector<std::uint32_t> edges;
    for (int k = 0; k < count; ++k) {
      graph.add_edge(Between(pose(std::type_identity<T>())), information(kDim, kinds == 3 ? k % 3 : kinds),
                     vertices[k % 5], vertices[(k + 1 + k % 3) % 5]);
      edges.push_back(static_cast<std::uint32_t>(count - 1 - k));
    }
    const detail::EdgePool& pool = *graph.edge_pools()[0];
    std::vector<double> error[2], jacobian[2];
    detail::EdgeTile tile[2];
    for (int lanes = 0; lanes < 2; ++lanes) {
      error[lanes].resize(kDim * detail::EdgeTile::kCapacity);
      jacobian[lanes].resize(2 * kDim * error[lanes].size());
      tile[lanes].error = error[lanes].data();
      tile[lanes].jacobian = jacobian[lanes].data();
      tile[lanes].in_lanes = lanes == 1;
      pool.linearize(edges, tile[lanes], false);
      ASSERT_EQ(tile[lanes].in_lanes, lanes == 1);
    }
    const auto expect_same = [&](const double* plain, const double* by_lanes, int size) {
      for (int k = 0; k < count; ++k) {
        for (int m = 0; m < size; ++m) {
          const int lane = ((k / detail::EdgeTile::kLanes) * size + m) * detail::EdgeTile::kLanes +
                           k % detail::EdgeTile::kLanes;
          ASSERT_NEAR(by_lanes[lane], plain[k * size + m], 1e-13 * (1 + 30 * std::abs(plain[k * size + m])))
              << "value " << m << " of edge " << k;
        }
      }
    };
    expect_same(tile[0].error, tile[1].error, kDim);
    expect_same(tile[0].jacobian, tile[1].jacobian, 2 * kDim * kDim);

    std::vector<double> chi2(edges.size());
    pool.chi2(edges, chi2.data());
    for (int k = 0; k < count; ++k) {
      const double expected = pool.information(edges[k]).squared_norm(tile[0].error + k * kDim);
      EXPECT_NEAR(chi2[k], expected, 1e-12 * (1 + expected));
    }
  }

 private:
  std::mt19937 random_{1};
};

TEST_P(BetweenLanes, AgreeWithTheFunctionsForOneEdgeForAnyNumberOfEdgesAndKindOfInformation) {
  for (const int count : {1, 2, 3, 7, 8, 9, 17, 24}) {
    for (int kinds = 0; kinds < 4; ++kinds) {
      compare<SE2>(count, kinds);
      compare<SE3>(count, kinds);
    }
  }
}

TEST_P(BetweenLanes, WrapAnglesLikeTheFunctionForOneEdge) {
  Graph graph;
  std::vector<std::uint32_t> edges;
  for (const double from : {-3.0, -kPi / 2, 0.0, 1.0, 3.0, kPi}) {
    for (const double to : {-3.1, -kPi / 2, 0.0, 2.0, kPi}) {
      for (const double measured : {-3.1, 0.0, 3.1, kPi}) {
        const auto a = graph.add_vertex(SE2(0, 0, from)), b = graph.add_vertex(SE2(1, 0, to));
        edges.push_back(static_cast<std::uint32_t>(edges.size()));
        graph.add_edge(Between(SE2(0, 1, measured)), 1.0, a, b);
      }
    }
  }
  const detail::EdgePool& pool = *graph.edge_pools()[0];
  for (const std::uint32_t& edge : edges) {
    double plain[3], lanes[3 * detail::EdgeTile::kLanes];
    pool.errors(std::span(&edge, 1), plain);
    ASSERT_TRUE(pool.errors_in_lanes(std::span(&edge, 1), lanes));
    EXPECT_EQ(lanes[2 * detail::EdgeTile::kLanes], plain[2]);
  }
}

/// Edges are processed in tiles of at most EdgeTile::kCapacity edges. The number of workers determines which
/// edges share a tile, so chi2 must not depend on it. Edges with different kinds of Ω may share a tile.
TEST_P(BetweenLanes, ComputeTheSameBitsOfTheChi2OfAnEdgeWhicheverEdgesShareItsTile) {
  Graph graph;
  const auto a = graph.add_vertex(SE3()), b = graph.add_vertex(pose(std::type_identity<SE3>()));
  std::vector<std::uint32_t> edges;
  for (int k = 0; k < 30; ++k) {
    graph.add_edge(Between(pose(std::type_identity<SE3>())), information(6, k % 3), a, b);
    edges.push_back(static_cast<std::uint32_t>(k));
  }
  const detail::EdgePool& pool = *graph.edge_pools()[0];
  std::vector<double> together(30), alone(30);
  pool.chi2(edges, together.data());
  for (std::size_t k = 0; k < 30; ++k) pool.chi2(std::span(&edges[k], 1), &alone[k]);
  EXPECT_EQ(together, alone);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, BetweenLanes, ::testing::ValuesIn(dense::usable_kernels()),
                         name_of_isa);

}  // namespace
}  // namespace boxplus
