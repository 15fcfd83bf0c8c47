// SPDX-License-Identifier: BSD-3-Clause
// All direct solvers use the limits of lost_pivot.h, so they agree on which matrices are positive definite.
#include <gtest/gtest.h>

#include <cmath>

#include "linear/every_solver.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

class Pivots : public ::testing::TestWithParam<LinearSolverKind> {
 protected:
  FactorResult factorize(const TestSystem& system, const Damping& damping = {}) const {
    const auto solver = make_linear_solver(GetParam());
    solver->analyze(system.structure, {});
    return solver->factorize(system.view(), damping);
  }
};

/// The Hessian of a 2-D pose graph (x, y, angle): a random walk of unit steps with loop closures.
TestSystem pose_graph(std::uint32_t poses, std::uint32_t loops, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-0.5, 0.5);
  std::vector<Eigen::Vector3d> pose{{0, 0, 0}};
  for (std::uint32_t i = 1; i < poses; ++i) {
    const Eigen::Vector3d& p = pose.back();
    pose.push_back({p[0] + std::cos(p[2]), p[1] + std::sin(p[2]), p[2] + turn(random)});
  }
  auto edges = chain_edges(poses);
  for (std::uint32_t l = 0; l < loops; ++l) {
    const auto i = static_cast<std::uint32_t>(random() % poses),
               j = static_cast<std::uint32_t>(random() % poses);
    if (i != j) edges.push_back({std::max(i, j), std::min(i, j)});
  }
  TestSystem system(std::vector<std::uint32_t>(poses, 3), edges);
  for (const auto& [j, i] : edges) {
    const Eigen::Matrix2d rotated = Eigen::Rotation2Dd(-pose[i][2]).toRotationMatrix();
    const Eigen::Vector2d step = (pose[j] - pose[i]).head<2>();
    Eigen::Matrix3d from = -Eigen::Matrix3d::Identity(), to = Eigen::Matrix3d::Identity();
    from.topLeftCorner<2, 2>() = -rotated;
    from.topRightCorner<2, 1>() = rotated * Eigen::Vector2d(step[1], -step[0]);
    to.topLeftCorner<2, 2>() = rotated;
    const Eigen::Matrix3d weight = Eigen::Vector3d(10, 10, 30).asDiagonal();
    system.add_edge(i, j, weight * from, weight * to);
  }
  return system;
}

TEST_P(Pivots, OfAPoseGraphWithoutAnchorAreNotAllPositive) {
  for (const std::uint32_t poses : {2u, 10u, 100u, 400u}) {
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      const TestSystem system = pose_graph(poses, poses / 10, seed);
      const FactorResult result = factorize(system);
      EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite) << poses << " poses, seed " << seed;
      EXPECT_LT(result.failed_block, poses);
    }
  }
}

TEST_P(Pivots, OfAnAnchoredPoseGraphAreAllPositive) {
  for (const double anchor : {1.0, 1e-3, 1e6}) {
    TestSystem system = pose_graph(400, 40, 1);
    system.block(0, 0).diagonal().array() += anchor;
    EXPECT_EQ(factorize(system).status, LinearStatus::kOk) << "anchor " << anchor;
  }
}

TEST_P(Pivots, OfADampedPoseGraphAreAllPositive) {
  const TestSystem system = pose_graph(300, 40, 2);
  EXPECT_EQ(factorize(system, {.lambda = 1e-4}).status, LinearStatus::kOk);
}

TEST_P(Pivots, OfALaplacianAreNotAllPositive) {
  for (const std::uint32_t size : {2u, 5u, 20u}) {
    TestSystem system(std::vector<std::uint32_t>(size * size, 2), grid_edges(size, size));
    const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity() / 3;
    for (const auto& [i, j] : grid_edges(size, size)) system.add_edge(i, j, identity, -identity);
    EXPECT_EQ(factorize(system).status, LinearStatus::kNotPositiveDefinite) << size;
  }
}

TEST_P(Pivots, OfAComponentWithoutAnchorAreNotAllPositiveEvenIfOtherComponentsHaveAnchors) {
  TestSystem system(std::vector<std::uint32_t>(9, 1), {{1, 0}, {2, 1}, {4, 3}, {5, 4}, {7, 6}, {8, 7}});
  const Eigen::MatrixXd one = Eigen::MatrixXd::Constant(1, 1, 0.7);
  for (const std::uint32_t i : {0u, 1u, 3u, 4u, 6u, 7u}) system.add_edge(i, i + 1, one, -one);
  system.block(0, 0) += one;
  system.block(8, 8) += one;
  const FactorResult result = factorize(system);
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  EXPECT_GE(result.failed_block, 3u);
  EXPECT_LE(result.failed_block, 5u);
}

TEST_P(Pivots, OfALongChainAnchoredAtOneEndAreAllPositive) {
  TestSystem system(std::vector<std::uint32_t>(1000, 1), chain_edges(1000));
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  for (std::uint32_t i = 0; i + 1 < 1000; ++i) system.add_edge(i, i + 1, one, -one);
  system.block(0, 0) += one;
  EXPECT_EQ(factorize(system).status, LinearStatus::kOk);
}

TEST_P(Pivots, OfAFullMatrixOfCondition1e12AreAllPositive) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Eigen::MatrixXd q =
        Eigen::HouseholderQR<Eigen::MatrixXd>(random_matrix(24, 24, random)).householderQ();
    Eigen::VectorXd spectrum(24);
    for (int i = 0; i < 24; ++i) spectrum[i] = std::pow(10, -12.0 * i / 23);
    const Eigen::MatrixXd full = q * spectrum.asDiagonal() * q.transpose();
    TestSystem system({24}, {});
    system.block(0, 0) = full;
    EXPECT_EQ(factorize(system).status, LinearStatus::kOk);
  }
}

TEST_P(Pivots, DoNotDependOnTheScaleOfTheUnknowns) {
  TestSystem system({2, 2}, {{1, 0}});
  Eigen::Matrix4d full = Eigen::Matrix4d::Identity() * 2;
  full(2, 0) = full(0, 2) = 1;
  const Eigen::Vector4d scale(1e-150, 1, 1e100, 1e-3);
  full = scale.asDiagonal() * full * scale.asDiagonal();
  system.block(0, 0) = full.topLeftCorner<2, 2>();
  system.block(1, 0) = full.bottomLeftCorner<2, 2>();
  system.block(1, 1) = full.bottomRightCorner<2, 2>();
  EXPECT_EQ(factorize(system).status, LinearStatus::kOk);
}

TEST_P(Pivots, OfABlockWithAZeroRowAreReportedWithThisBlock) {
  TestSystem system({2, 2, 2}, {{1, 0}});
  system.add_to_diagonal(1);
  system.block(1, 1)(1, 1) = 0;
  EXPECT_EQ(factorize(system).status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(factorize(system).failed_block, 1u);
}

INSTANTIATE_TEST_SUITE_P(Direct, Pivots, ::testing::ValuesIn(every_direct_solver()),
                         [](const auto& test) { return std::string(to_string(test.param)); });

}  // namespace
}  // namespace boxplus
