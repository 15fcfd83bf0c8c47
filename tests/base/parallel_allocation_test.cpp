// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "boxplus/base/parallel.h"

namespace {
std::atomic<int> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace boxplus {
namespace {

TEST(ParallelTasks, AllocateNothingOnceTheWorkersExist) {
  std::atomic<int> runs{0};
  parallel_tasks(4, [&](int) { ++runs; });
  const int before = allocations;
  for (int call = 0; call < 100; ++call) parallel_tasks(1 + call % 4, [&](int) { ++runs; });
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(runs, 4 + 250);
}

}  // namespace
}  // namespace boxplus
