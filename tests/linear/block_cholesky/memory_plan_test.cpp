// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/memory_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace boxplus {
namespace {

TEST(MemoryPlan, ReusesReleasedSpaceAndMergesAdjacentGaps) {
  MemoryPlan plan;
  const auto a = plan.reserve(10), b = plan.reserve(5), c = plan.reserve(1);
  plan.release(a, 10);
  plan.release(b, 5);
  EXPECT_EQ(plan.reserve(15), a);
  EXPECT_EQ(c, 15u);
  EXPECT_EQ(plan.peak(), 16u);
}

TEST(MemoryPlan, ExtendsAGapAtTheEnd) {
  MemoryPlan plan;
  plan.reserve(4);
  plan.release(plan.reserve(4), 4);
  EXPECT_EQ(plan.reserve(6), 4u);
  EXPECT_EQ(plan.peak(), 10u);
}

TEST(MemoryPlan, NeverLetsReservedBuffersOverlap) {
  struct Buffer {
    std::uint64_t begin, end;
  };
  std::mt19937 random(1);
  MemoryPlan plan;
  std::vector<Buffer> living;
  for (int step = 0; step < 2000; ++step) {
    if (living.size() > 20 || (!living.empty() && random() % 2)) {
      const auto victim = living.begin() + static_cast<std::ptrdiff_t>(random() % living.size());
      plan.release(victim->begin, victim->end - victim->begin);
      living.erase(victim);
      continue;
    }
    const std::uint64_t size = 1 + random() % 50, begin = plan.reserve(size);
    for (const Buffer& other : living) EXPECT_TRUE(begin + size <= other.begin || other.end <= begin);
    EXPECT_LE(begin + size, plan.peak());
    living.push_back({begin, begin + size});
  }
}

}  // namespace
}  // namespace boxplus
