// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/block_cholesky.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cstring>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/reference_cholesky.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

std::vector<double> solve(BlockCholesky& solver, const std::vector<double>& b) {
  std::vector<double> x(b.size());
  EXPECT_EQ(solver.solve(b.data(), 1, x.data(), {}).status, LinearStatus::kOk);
  return x;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, size = 1e-300;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return largest / size;
}

void expect_as_reference(const TestSystem& system, const AnalyzeHints& hints, const AmalgamationRule& rule) {
  const Damping damping{.lambda = 0.01};
  BlockCholesky fast({}, rule);
  fast.analyze(system.structure, hints);
  ASSERT_EQ(fast.factorize(system.view(), damping, {}).status, LinearStatus::kOk);
  const ReferenceCholesky reference(system.structure, system.values, damping);
  ASSERT_EQ(reference.result().status, LinearStatus::kOk);
  const std::vector<double> b(system.structure.scalars(), 1.0);
  EXPECT_LT(difference(solve(fast, b), reference.solve(b)), 1e-9);
}

TEST(BlockCholesky, SolvesLikeTheReferenceOn200RandomStructures) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const TestSystem system = random_system(1 + seed % 60, seed % 50, seed);
    SCOPED_TRACE(seed);
    expect_as_reference(system, {}, {});
  }
}

TEST(BlockCholesky, SolvesLikeTheReferenceWhetherItMergesFrontsOrNot) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const TestSystem system = random_system(1 + seed, seed, seed);
    expect_as_reference(system, {}, {.max_zero_fraction = -1});
    expect_as_reference(system, {}, {.per_front = 1e9, .max_zero_fraction = 1});
  }
}

TEST(BlockCholesky, SolvesLikeTheReferenceIfSomeBlocksMustComeLast) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const TestSystem system = random_system(20 + seed, seed, seed);
    const std::vector<std::uint32_t> last{3, 11, 0, 19};
    expect_as_reference(system, {.last = last}, {});
    expect_as_reference(system, {.last = last}, {.per_front = 1e9, .max_zero_fraction = 1});
  }
}

TEST(BlockCholesky, HasResidualsAsSmallAsRoundingErrorsOnRandomStructures) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const auto blocks = *rc::gen::inRange<std::uint32_t>(1, 80);
    const auto loops = *rc::gen::inRange<std::uint32_t>(0, 80);
    const TestSystem system = random_system(blocks, loops, seed);
    BlockCholesky solver;
    solver.analyze(system.structure, {});
    RC_ASSERT(solver.factorize(system.view(), {}, {}).status == LinearStatus::kOk);
    const std::vector<double> b(system.structure.scalars(), 1.0);
    std::vector<double> x(b.size()), y(b.size());
    RC_ASSERT(solver.solve(b.data(), 1, x.data(), {}).status == LinearStatus::kOk);
    system.view().multiply(x.data(), y.data());
    RC_ASSERT(difference(y, b) < 1e-9);
  }));
}

TEST(BlockCholesky, JoinsBlocksIntoSupernodes) {
  std::mt19937 random(1);
  const TestSystem grid = random_system(std::vector<std::uint32_t>(100, 3), grid_edges(10, 10), random);
  BlockCholesky solver;
  solver.analyze(grid.structure, {});
  EXPECT_LT(solver.statistics().supernodes, 60u);
  EXPECT_GT(solver.statistics().largest_front, 3u * 10);
  EXPECT_GT(solver.statistics().factor_nonzeros, grid.structure.nonzero_values());
}

/// A system that is so large that threads process subtrees in parallel, and that several threads share the
/// largest fronts.
TestSystem large_grid() {
  std::mt19937 random(9);
  return random_system(std::vector<std::uint32_t>(900, 6), grid_edges(30, 30), random);
}

TEST(BlockCholesky, UsesTheOrderThatTheHintsGive) {
  std::mt19937 random(3);
  const TestSystem grid = random_system(std::vector<std::uint32_t>(100, 3), grid_edges(10, 10), random);
  BlockCholesky first({.ordering = Ordering::kNestedDissection}), second;
  first.analyze(grid.structure, {});
  const std::vector<std::uint32_t> order(first.elimination_order().begin(), first.elimination_order().end());
  second.analyze(grid.structure, {.order = order});
  EXPECT_EQ(second.statistics().factor_flops, first.statistics().factor_flops);
  const std::vector<double> b(grid.structure.scalars(), 1.0);
  ASSERT_EQ(second.factorize(grid.view(), {}, {}).status, LinearStatus::kOk);
  std::vector<double> x = solve(second, b), y(b.size());
  grid.view().multiply(x.data(), y.data());
  EXPECT_LT(difference(y, b), 1e-9);
}

TEST(BlockCholesky, RefusesAnOrderThatIsNotAPermutationOfAllBlocks) {
  const auto chain = make_block_structure(std::vector<std::uint32_t>(3, 2), chain_edges(3));
  for (const std::vector<std::uint32_t>& order :
       {std::vector<std::uint32_t>{0, 1}, std::vector<std::uint32_t>{0, 1, 1},
        std::vector<std::uint32_t>{0, 1, 3}, std::vector<std::uint32_t>{0, 1, 2, 2}}) {
    BlockCholesky solver;
    EXPECT_THROW(solver.analyze(chain, {.order = order}), InvalidArgument);
  }
}

TEST(BlockCholesky, ComputesTheSameBitsEveryTimeOnAnyNumberOfThreads) {
  const TestSystem system = large_grid();
  const std::vector<double> b(system.structure.scalars(), 1.0);
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 1, 2, 3}) {
    BlockCholesky solver;
    solver.analyze(system.structure, {.threads = threads});
    EXPECT_EQ(solver.symbolic().schedule.is_parallel(), threads > 1);
    EXPECT_GT(solver.symbolic().panel_size, 200'000u)
        << "the factor must be large enough for a parallel solve";
    for (int repeat = 0; repeat < 2; ++repeat) {
      ASSERT_EQ(solver.factorize(system.view(), {}, {}).status, LinearStatus::kOk);
      solutions.push_back(solve(solver, b));
    }
  }
  for (const auto& x : solutions) EXPECT_EQ(x, solutions.front());
}

TEST(BlockCholesky, ReportsTheSameFailedBlockOnAnyNumberOfThreads) {
  TestSystem system = large_grid();
  for (const std::uint32_t bad : {100u, 450u, 700u}) system.block(bad, bad).diagonal().array() -= 1e3;
  std::vector<std::uint32_t> named;
  for (const int threads : {1, 2, 3}) {
    BlockCholesky solver;
    solver.analyze(system.structure, {.threads = threads});
    named.push_back(solver.factorize(system.view(), {}, {}).failed_block);
  }
  EXPECT_THAT(named, ::testing::Each(named.front()));
  EXPECT_THAT(named.front(), ::testing::AnyOf(100, 450, 700));
}

TEST(BlockCholesky, NeverReportsAStopAsALostPivot) {
  const TestSystem system = large_grid();
  for (const int threads : {1, 2, 3}) {
    BlockCholesky solver;
    solver.analyze(system.structure, {.threads = threads});
    for (double seconds = 0; seconds < 0.01; seconds += 0.0005) {  // at any time of the factorization
      const StopToken stop(nullptr, StopToken::Clock::now(), seconds);
      const LinearStatus status = solver.factorize(system.view(), {}, {.stop = stop}).status;
      EXPECT_TRUE(status == LinearStatus::kStopped || (status == LinearStatus::kOk && seconds > 0));
    }
  }
}

TEST(BlockCholesky, SolvesLikeTheReferenceOnTwoThreadsIfSomeBlocksMustComeLast) {
  const TestSystem system = large_grid();
  const std::vector<std::uint32_t> last{400, 5, 899, 17};
  expect_as_reference(system, {.threads = 2, .last = last}, {});
}

TEST(BlockCholesky, ComputesTheSameInverseByColumnsAndOnThePatternOfTheFactor) {
  const TestSystem system = large_grid();
  BlockCholesky solver;
  solver.analyze(system.structure, {});
  ASSERT_EQ(solver.factorize(system.view(), {}, {}).status, LinearStatus::kOk);
  std::vector<BlockCoordinate> few{{450, 450}}, all;
  for (std::uint32_t block = 0; block < 900; ++block) all.push_back({block, block});
  std::vector<double> by_columns(36), on_pattern(std::size_t{900} * 36);
  ASSERT_TRUE(solver.selected_inverse(few, by_columns.data()));  // a single block is cheaper by columns
  ASSERT_TRUE(solver.selected_inverse(all, on_pattern.data()));
  const auto same = on_pattern.begin() + std::ptrdiff_t{450} * 36;
  EXPECT_LT(difference(by_columns, std::vector(same, same + 36)), 1e-10);
  EXPECT_NE(by_columns, std::vector(same, same + 36))
      << "the bits must differ, because the two calls compute in different ways";
}

TEST(BlockCholesky, ReportsTheBlockWhosePivotIsNotPositive) {
  TestSystem system = random_system(40, 20, 3);
  for (const std::uint32_t bad : {0u, 13u, 39u}) {
    const std::vector<double> values = system.values;
    system.block(bad, bad).diagonal().array() -= 1e3;
    BlockCholesky solver;
    solver.analyze(system.structure, {});
    const FactorResult result = solver.factorize(system.view(), {}, {});
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
    EXPECT_EQ(result.failed_block, bad);
    system.values = values;
  }
}

TEST(BlockCholesky, RefusesToSolveBeforeAFactorization) {
  const TestSystem system = random_system(3, 0, 3);
  std::vector<double> b(system.structure.scalars(), 1.0);
  BlockCholesky solver;
  EXPECT_THROW((void)solver.factorize(system.view(), {}, {}), InvalidArgument);
  solver.analyze(system.structure, {});
  EXPECT_THROW((void)solver.solve(b.data(), 1, b.data(), {}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
