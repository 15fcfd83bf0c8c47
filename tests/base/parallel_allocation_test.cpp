// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <new>

#include "allocation_counter.h"
#include "boxplus/base/parallel.h"

namespace boxplus {
namespace {

TEST(AllocationCounter, CountsAllocationsByOperatorNewAndByEigen) {
  if (!testing::allocations_are_counted()) GTEST_SKIP();
  const long before = testing::allocation_count();
  ::operator delete(::operator new(1));  // a new-expression might be optimized away
  EXPECT_EQ(testing::allocation_count() - before, 1);
  const Eigen::VectorXd vector = Eigen::VectorXd::Ones(before + 100);
  EXPECT_EQ(testing::allocation_count() - before, 2);
  EXPECT_EQ(vector[before], 1);
}

TEST(ParallelTasks, AllocateNothingOnceTheWorkersExist) {
  if (!testing::allocations_are_counted()) GTEST_SKIP();
  std::atomic<int> runs{0};
  detail::parallel_tasks(4, [&](int) { ++runs; });
  const long before = testing::allocation_count();
  for (int call = 0; call < 100; ++call) detail::parallel_tasks(1 + call % 4, [&](int) { ++runs; });
  EXPECT_EQ(testing::allocation_count(), before);
  EXPECT_EQ(runs, 4 + 250);
}

}  // namespace
}  // namespace boxplus
