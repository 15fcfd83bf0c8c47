// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/tree_schedule.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "linear/block_cholesky/block_cholesky.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

double load_of(const std::vector<TreeSchedule::Subtree>& share) {
  return std::accumulate(share.begin(), share.end(), 0.0,
                         [](double sum, const auto& subtree) { return sum + subtree.time; });
}

constexpr int kAll = 1000;

/// The owner of each front: the index of a thread, or kAll if all threads process the front at the end.
std::vector<int> owners(const SymbolicFactor& f) {
  constexpr int kNobody = -1;
  std::vector<int> owner(f.fronts.size(), kNobody);
  const auto give = [&](std::uint32_t front, int to) {
    EXPECT_EQ(owner[front], kNobody) << "front " << front << " is scheduled twice";
    owner[front] = to;
  };
  for (std::size_t t = 0; t < f.schedule.threads.size(); ++t) {
    for (const auto& subtree : f.schedule.threads[t]) {
      for (std::uint32_t s = subtree.begin; s < subtree.end; ++s) give(s, static_cast<int>(t));
    }
  }
  for (const std::uint32_t s : f.schedule.top) give(s, kAll);
  EXPECT_THAT(owner, ::testing::Each(::testing::Ne(kNobody)));
  return owner;
}

void expect_valid(const SymbolicFactor& f) {
  const std::vector<int> owner = owners(f);
  for (std::uint32_t s = 0; s < f.fronts.size(); ++s) {
    const std::uint32_t parent = f.fronts[s].parent;
    if (parent == kNoParent) continue;
    EXPECT_GE(owner[parent], owner[s]) << "a front must not come before its children";
    EXPECT_TRUE(owner[parent] == kAll || owner[parent] == owner[s])
        << "one thread must process a whole subtree";
  }
  EXPECT_TRUE(std::is_sorted(f.schedule.top.begin(), f.schedule.top.end()));
}

TEST(TreeSchedule, ProcessesEachFrontOnceAfterItsChildren) {
  for (const int threads : {2, 3, 7}) expect_valid(analyze_structure(cube(9, 6), {}, {}, threads));
}

TEST(TreeSchedule, DividesTheWorkEvenlyAndLeavesFewFrontsForAllThreads) {
  const auto grid = make_block_structure(std::vector<std::uint32_t>(1600, 6), grid_edges(40, 40));
  const SymbolicFactor f = analyze_structure(grid, {}, {}, 2);
  ASSERT_EQ(f.schedule.threads.size(), 2u);
  const double first = load_of(f.schedule.threads[0]), second = load_of(f.schedule.threads[1]);
  EXPECT_LT(std::max(first, second), 1.25 * std::min(first, second));
  EXPECT_LT(f.schedule.top.size(), 8u);
}

TEST(TreeSchedule, LeavesNoFrontsForAllThreadsIfTheGraphConsistsOfEqualParts) {
  constexpr std::uint32_t kSide = 20, kPieces = 4;
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t piece = 0; piece < kPieces; ++piece) {
    for (const auto& [i, j] : grid_edges(kSide, kSide))
      edges.push_back({i + piece * kSide * kSide, j + piece * kSide * kSide});
  }
  const auto pieces = make_block_structure(std::vector<std::uint32_t>(kPieces * kSide * kSide, 6), edges);
  const SymbolicFactor f = analyze_structure(pieces, {}, {}, 2);
  expect_valid(f);
  EXPECT_THAT(f.schedule.top, ::testing::IsEmpty());
}

TEST(TreeSchedule, IsValidIfManyBlocksMustComeLast) {
  std::vector<std::uint32_t> last(300);
  std::iota(last.begin(), last.end(), 200u);
  expect_valid(analyze_structure(cube(9, 6), last, {}, 3));
}

TEST(TreeSchedule, UsesOneThreadForASmallGraphAndAllThreadsForALargeGraph) {
  const auto workers = [](std::uint32_t side) {
    const auto grid =
        make_block_structure(std::vector<std::uint32_t>(side * side, 6), grid_edges(side, side));
    BlockCholesky solver;
    solver.analyze(grid, {.threads = 2});
    return solver.statistics().workers;
  };
  EXPECT_EQ(workers(40), 2);
  EXPECT_EQ(workers(4), 1);
}

TEST(TreeSchedule, IsNotParallelIfThereIsLittleWork) {
  const auto chain = make_block_structure(std::vector<std::uint32_t>(50, 3), chain_edges(50));
  EXPECT_FALSE(analyze_structure(chain, {}, {}, 4).schedule.is_parallel());
}

}  // namespace
}  // namespace boxplus
