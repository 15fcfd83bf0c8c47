// SPDX-License-Identifier: BSD-3-Clause
// Tests that every implementation of LinearSolver must pass.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "linear/every_solver.h"
#include "linear/expect_solution.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Candidate {
  detail::LinearSolverEntry solver;
  Precision precision = Precision::kDouble;
  bool eliminates = false;  ///< whether a SchurSolver contains the solver
};

std::shared_ptr<LinearSolver> make(const Candidate& candidate) {
  std::shared_ptr<LinearSolver> solver =
      candidate.solver.make({.block_cholesky = {.precision = candidate.precision}});
  return candidate.eliminates ? make_schur_solver(std::move(solver)) : solver;
}

/// The largest k such that no two of the first k blocks are connected.
std::uint32_t independent_blocks(const BlockStructure& structure) {
  std::uint32_t first_connected = structure.blocks();  // the first block with a connection to an earlier one
  for (std::uint32_t j = 0; j < first_connected; ++j) {
    for (std::uint32_t k = structure.column_start[j] + 1; k < structure.column_start[j + 1]; ++k)
      first_connected = std::min(first_connected, structure.row[k]);
  }
  return first_connected;
}

class LinearSolverTest : public ::testing::TestWithParam<Candidate> {
 protected:
  LinearSolverTest() : solver(make(GetParam())) {}

  FactorResult factorize(const TestSystem& system, const Damping& damping = {}) {
    solver->analyze(system.structure,
                    {.right_hand_sides = 3, .eliminated_blocks = independent_blocks(system.structure)});
    view.emplace(system.view());
    return solver->factorize(*view, damping, control);
  }

  MatrixXd solve(const MatrixXd& b) {
    MatrixXd x = MatrixXd::Constant(b.rows(), b.cols(), kNan);
    EXPECT_EQ(solver->solve(b.data(), static_cast<int>(b.cols()), x.data(), control).status,
              LinearStatus::kOk);
    return x;
  }

  static bool is_iterative() {
    return GetParam().solver.method == detail::LinearSolverEntry::Method::kIterative;
  }

  std::shared_ptr<LinearSolver> solver;
  std::optional<AssembledSystem> view;
  SolveControl control{.relative_tolerance = 1e-12};
};

TEST_P(LinearSolverTest, HasTheNameOfItsKind) {
  EXPECT_EQ(solver->name(), GetParam().solver.name);
}

TEST_P(LinearSolverTest, SolvesRandomSystemsOfMixedBlockSizes) {
  for (std::uint32_t seed = 0; seed < 25; ++seed) {
    TestSystem system = random_system(1 + 2 * seed, seed, seed);
    ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
    const MatrixXd b = right_hand_sides(system, 1);
    expect_solution(system.dense(), solve(b), b);
  }
}

TEST_P(LinearSolverTest, SolvesSystemsOfOneBlockSize) {
  for (const std::uint32_t dim : {1u, 2u, 3u, 4u, 6u, 7u, 9u, 15u, 40u}) {
    std::mt19937 random(dim);
    const auto edges = grid_edges(3, 4);
    TestSystem system = random_system(std::vector<std::uint32_t>(12, dim), edges, random);
    ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
    const MatrixXd b = right_hand_sides(system, 1);
    expect_solution(system.dense(), solve(b), b);
  }
}

/// Points of mixed sizes, followed by cameras. No two points are connected. Each camera sees some of the
/// points, and is connected to the camera before it.
TestSystem points_and_cameras(std::uint32_t points, std::uint32_t cameras, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> dims;
  for (std::uint32_t p = 0; p < points; ++p) dims.push_back(1 + random() % 4);
  for (std::uint32_t c = 0; c < cameras; ++c) dims.push_back(c % 3 == 0 ? 9 : 6);
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t c = points; c < points + cameras; ++c) {
    for (std::uint32_t p = 0; p < points; ++p) {
      if (random() % 3 != 0) edges.push_back({c, p});
    }
    if (c > points) edges.push_back({c, c - 1});
  }
  return random_system(dims, edges, random);
}

TEST_P(LinearSolverTest, SolvesSystemsOfPointsAndCameras) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    TestSystem system = points_and_cameras(30, 4 + seed, seed);
    ASSERT_EQ(factorize(system, {.lambda = 0.5}).status, LinearStatus::kOk);
    MatrixXd a = system.dense();
    a.diagonal().array() += 0.5;
    const MatrixXd b = right_hand_sides(system, 4);
    expect_solution(a, solve(b), b);
  }
}

TEST_P(LinearSolverTest, ReportsThePointOrCameraThatIsNotPositiveDefinite) {
  for (const std::uint32_t bad : {0u, 17u, 29u, 30u, 35u}) {
    TestSystem system = points_and_cameras(30, 6, 1);
    system.block(bad, bad)(0, 0) = -1;
    const FactorResult result = factorize(system);
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
    EXPECT_EQ(result.failed_block, bad);
  }
}

TEST_P(LinearSolverTest, ComputesTheInverseOfPointsAndCameras) {
  TestSystem system = points_and_cameras(12, 4, 2);
  ASSERT_EQ(factorize(system, {.lambda = 0.5}).status, LinearStatus::kOk);
  MatrixXd a = system.dense();
  a.diagonal().array() += 0.5;
  const MatrixXd inverse = a.inverse();
  const BlockStructure& s = system.structure;
  for (std::uint32_t i = 0; i < s.blocks(); ++i) {
    for (std::uint32_t j = 0; j <= i; ++j) {
      const std::vector<BlockCoordinate> wanted{{i, j}};
      MatrixXd block = MatrixXd::Constant(s.dim(i), s.dim(j), kNan);
      if (!solver->selected_inverse(wanted, block.data())) {
        EXPECT_TRUE(is_iterative());
        return;
      }
      const MatrixXd expected = inverse.block(s.offset[i], s.offset[j], s.dim(i), s.dim(j));
      EXPECT_LT((block - expected).norm(), 1e-9 * inverse.norm()) << i << ", " << j;
    }
  }
}

TEST_P(LinearSolverTest, ReportsWhetherTheSolutionIsExact) {
  TestSystem system = random_system(20, 20, 4);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  MatrixXd b = right_hand_sides(system, 1);
  const SolveResult result = solver->solve(b.data(), 1, b.data(), control);
  EXPECT_EQ(result.exact, !is_iterative() && GetParam().precision != Precision::kMixed);
}

TEST_P(LinearSolverTest, AddsDampingWithoutChangingTheValues) {
  TestSystem system = random_system(20, 20, 4);
  const std::vector<double> values = system.values;
  const MatrixXd b = right_hand_sides(system, 1);
  MatrixXd a = system.dense();
  ASSERT_EQ(factorize(system, {.lambda = 3}).status, LinearStatus::kOk);
  expect_solution(a + 3 * MatrixXd::Identity(a.rows(), a.cols()), solve(b), b);
  const VectorXd diagonal = VectorXd::LinSpaced(a.rows(), 0, 2);
  ASSERT_EQ(factorize(system, {.lambda = 5, .diagonal = diagonal.data()}).status, LinearStatus::kOk);
  expect_solution(a + 5 * MatrixXd(diagonal.asDiagonal()), solve(b), b);
  EXPECT_EQ(system.values, values);
}

TEST_P(LinearSolverTest, SolvesForMoreRightHandSidesThanTheHintsPromised) {
  TestSystem system = random_system(20, 20, 5);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  for (const int columns : {0, 1, 2, 3, 4, 8}) {
    const MatrixXd b = right_hand_sides(system, columns);
    const MatrixXd x = solve(b);
    if (columns > 0) expect_solution(system.dense(), x, b);
  }
}

TEST_P(LinearSolverTest, SolvesInPlace) {
  TestSystem system = random_system(20, 20, 6);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  MatrixXd b = right_hand_sides(system, 3);
  const MatrixXd x = solve(b);
  ASSERT_EQ(solver->solve(b.data(), 3, b.data(), control).status, LinearStatus::kOk);
  EXPECT_EQ(b, x);
}

TEST_P(LinearSolverTest, ComputesAnyBlockOfTheInverse) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    TestSystem system = random_system(5 + 3 * seed, seed, seed);
    ASSERT_EQ(factorize(system, {.lambda = 0.1}).status, LinearStatus::kOk);
    MatrixXd a = system.dense();
    a.diagonal().array() += 0.1;
    const MatrixXd inverse = a.inverse();
    std::vector<BlockCoordinate> blocks;  // all blocks, many of them outside of the pattern
    const BlockStructure& s = system.structure;
    for (std::uint32_t i = 0; i < s.blocks(); ++i) {
      for (std::uint32_t j = 0; j <= i; ++j) blocks.push_back({i, j});
    }
    std::vector<double> out(static_cast<std::size_t>(a.size()), kNan);
    if (!solver->selected_inverse(blocks, out.data())) {
      EXPECT_TRUE(is_iterative());
      return;
    }
    const double* from = out.data();
    for (const auto [i, j] : blocks) {
      const Eigen::Map<const MatrixXd> block(from, s.dim(i), s.dim(j));
      const MatrixXd expected = inverse.block(s.offset[i], s.offset[j], s.dim(i), s.dim(j));
      EXPECT_LT((block - expected).norm(), 1e-8 * expected.norm() + 1e-12 * inverse.norm());
      from += block.size();
    }
  }
}

TEST_P(LinearSolverTest, ComputesTheInverseOfTheLastFactorizedMatrix) {
  TestSystem system({2}, {});
  system.add_to_diagonal(2);
  const std::vector<BlockCoordinate> blocks{{0, 0}};
  std::vector<double> out(4);
  for (const double scale : {1.0, 4.0}) {
    system.block(0, 0) = Eigen::Matrix2d::Identity() * scale;
    ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
    if (solver->selected_inverse(blocks, out.data())) {
      EXPECT_DOUBLE_EQ(out[0], 1 / scale);
    }
  }
}

TEST_P(LinearSolverTest, ReportsTheNegativeBlockOfABlockDiagonalMatrix) {
  for (std::uint32_t bad = 0; bad < 5; ++bad) {
    TestSystem system({3, 1, 6, 2, 3}, {});
    system.add_to_diagonal(1);
    system.block(bad, bad)(0, 0) = -1;
    const FactorResult result = factorize(system);
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
    EXPECT_EQ(result.failed_block, bad);
  }
}

TEST_P(LinearSolverTest, ReportsTheNegativeBlockOfAChain) {
  for (std::uint32_t bad = 0; bad < 12; bad += 3) {
    std::mt19937 random(1);
    TestSystem system = random_system(std::vector<std::uint32_t>(12, 3), chain_edges(12), random);
    system.block(bad, bad).diagonal().array() -= 100;
    const FactorResult result = factorize(system);
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
    EXPECT_EQ(result.failed_block, bad);
  }
}

TEST_P(LinearSolverTest, DetectsASingularLaplacian) {
  TestSystem system(std::vector<std::uint32_t>(36, 2), grid_edges(6, 6));
  const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
  for (const auto& [i, j] : grid_edges(6, 6)) system.add_edge(i, j, identity, -identity);
  const FactorResult result = factorize(system);
  if (is_iterative()) {  // only solve() can detect it, because each diagonal block is positive definite
    MatrixXd b = right_hand_sides(system, 1);
    EXPECT_NE(solver->solve(b.data(), 1, b.data(), control).status, LinearStatus::kOk);
  } else {
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  }
}

TEST_P(LinearSolverTest, ReportsTheDiagonalBlockThatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    TestSystem system = random_system(20, 20, 7);
    system.block(13, 13)(0, 0) = bad;
    const FactorResult result = factorize(system);
    EXPECT_EQ(result.status, LinearStatus::kNotFinite);
    EXPECT_EQ(result.failed_block, 13u);
  }
}

TEST_P(LinearSolverTest, ReportsTheColumnOfAnOffDiagonalBlockThatIsNotFinite) {
  TestSystem system({2, 3, 2, 2}, chain_edges(4));
  system.add_to_diagonal(10);
  system.block(2, 1)(1, 2) = kNan;
  const FactorResult result = factorize(system);
  EXPECT_EQ(result.status, LinearStatus::kNotFinite);
  EXPECT_EQ(result.failed_block, 1u);
}

TEST_P(LinearSolverTest, RefusesDampingThatIsNotFinite) {
  TestSystem system({2, 2}, {});
  system.add_to_diagonal(1);
  const VectorXd diagonal = VectorXd::Unit(4, 2);
  EXPECT_EQ(factorize(system, {.lambda = kNan}).status, LinearStatus::kNotFinite);
  const FactorResult result = factorize(system, {.lambda = kInfinity, .diagonal = diagonal.data()});
  EXPECT_EQ(result.status, LinearStatus::kNotFinite);
}

TEST_P(LinearSolverTest, RefusesRightHandSidesThatAreNotFinite) {
  TestSystem system = random_system(5, 0, 8);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  for (const double bad : {kNan, kInfinity}) {
    MatrixXd b = right_hand_sides(system, 2);
    b(b.rows() - 1, 1) = bad;
    EXPECT_EQ(solver->solve(b.data(), 2, b.data()).status, LinearStatus::kNotFinite);
  }
}

TEST_P(LinearSolverTest, SolvesAgainAfterAFailure) {
  TestSystem system = random_system(15, 10, 9);
  const std::vector<double> good = system.values;
  const MatrixXd b = right_hand_sides(system, 1);
  system.block(4, 4).diagonal().array() -= 1000;
  EXPECT_NE(factorize(system).status, LinearStatus::kOk);
  system.values = good;
  ASSERT_EQ(solver->factorize(system.view(), {}).status, LinearStatus::kOk);
  view.emplace(system.view());
  ASSERT_EQ(solver->factorize(*view, {}).status, LinearStatus::kOk);
  expect_solution(system.dense(), solve(b), b);
}

TEST_P(LinearSolverTest, AcceptsASystemWithoutBlocks) {
  const TestSystem system({}, {});
  EXPECT_EQ(factorize(system).status, LinearStatus::kOk);
  double nothing = 7;
  EXPECT_EQ(solver->solve(&nothing, 1, &nothing).status, LinearStatus::kOk);
  EXPECT_EQ(nothing, 7);
}

TEST_P(LinearSolverTest, SolvesASystemOfOneBlock) {
  TestSystem system({3}, {});
  system.block(0, 0) << 4, 1, 0, 1, 5, 2, 0, 2, 6;
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  const MatrixXd b = right_hand_sides(system, 1);
  expect_solution(system.dense(), solve(b), b);
}

TEST_P(LinearSolverTest, SolvesDisconnectedComponents) {
  std::mt19937 random(3);
  TestSystem system = random_system({3, 6, 3, 2, 1, 3}, {{2, 0}, {5, 1}}, random);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  const MatrixXd b = right_hand_sides(system, 2);
  expect_solution(system.dense(), solve(b), b);
}

TEST_P(LinearSolverTest, FactorizesNewValuesOfTheAnalyzedStructure) {
  TestSystem system = random_system(20, 20, 10);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  const MatrixXd b = right_hand_sides(system, 1);
  for (double& value : system.values) value *= 2.5;
  system.add_to_diagonal(1);
  ASSERT_EQ(solver->factorize(*view, {}).status, LinearStatus::kOk);
  expect_solution(system.dense(), solve(b), b);
}

TEST_P(LinearSolverTest, CanBeReusedForAnotherStructure) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    TestSystem system = random_system(10 * seed, 10, seed);
    ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
    const MatrixXd b = right_hand_sides(system, 1);
    expect_solution(system.dense(), solve(b), b);
  }
}

TEST_P(LinearSolverTest, ReadsOnlyTheLowerTriangleOfDiagonalBlocks) {
  if (is_iterative() || GetParam().precision == Precision::kMixed)
    GTEST_SKIP() << "iterations multiply by all values of the matrix";
  TestSystem system = random_system(10, 10, 11);
  const MatrixXd b = right_hand_sides(system, 1);
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  const MatrixXd x = solve(b);
  for (std::uint32_t j = 0; j < 10; ++j) {
    auto block = system.block(j, j);
    for (Eigen::Index c = 1; c < block.cols(); ++c) block.col(c).head(c).setConstant(1e6);
  }
  ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
  EXPECT_EQ(solve(b), x);
}

TEST_P(LinearSolverTest, IsStoppedByARaisedFlagAndByAPassedDeadline) {
  TestSystem system = random_system(20, 20, 12);
  const std::atomic<bool> flag{true};
  for (const StopToken& stop : {StopToken(&flag), StopToken(nullptr, StopToken::Clock::now(), 0)}) {
    control.stop = stop;
    EXPECT_EQ(factorize(system).status, LinearStatus::kStopped);
    control.stop = {};
    ASSERT_EQ(factorize(system).status, LinearStatus::kOk);
    MatrixXd b = right_hand_sides(system, 1);
    EXPECT_EQ(solver->solve(b.data(), 1, b.data(), {.stop = stop}).status, LinearStatus::kStopped);
    EXPECT_EQ(solver->solve(b.data(), 1, b.data()).status, LinearStatus::kOk)
        << "a stop token applies to one call only";
  }
}

TEST_P(LinearSolverTest, ContinuesAfterAStop) {
  TestSystem system = random_system(20, 20, 13);
  const std::atomic<bool> flag{true};
  control.stop = StopToken(&flag);
  ASSERT_EQ(factorize(system).status, LinearStatus::kStopped);
  control.stop = {};
  ASSERT_EQ(solver->factorize(*view, {}).status, LinearStatus::kOk);
  const MatrixXd b = right_hand_sides(system, 1);
  expect_solution(system.dense(), solve(b), b);
}

TEST_P(LinearSolverTest, IsNotStoppedByADistantDeadline) {
  const std::atomic<bool> flag{false};
  for (const double seconds : {1e6, 1e300, kInfinity}) {
    control.stop = StopToken(&flag, StopToken::Clock::now(), seconds);
    EXPECT_EQ(factorize(random_system(5, 3, 14)).status, LinearStatus::kOk);
  }
}

/// Every solver of the table, alone and inside a SchurSolver.
std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  for (const bool eliminates : {false, true}) {
    for (const detail::LinearSolverEntry& solver : every_solver()) {
      all.push_back({.solver = solver, .eliminates = eliminates});
      if (solver.kind == LinearSolverKind::kBlockCholesky)
        all.push_back({solver, Precision::kMixed, eliminates});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, LinearSolverTest, ::testing::ValuesIn(candidates()), [](const auto& test) {
  return std::string(test.param.eliminates ? "schur_" : "") + std::string(test.param.solver.name) +
         (test.param.precision == Precision::kMixed ? "_mixed" : "");
});

}  // namespace
}  // namespace boxplus
