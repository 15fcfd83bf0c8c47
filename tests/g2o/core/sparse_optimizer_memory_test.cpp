// SPDX-License-Identifier: BSD-3-Clause
// The memory of a process that optimizes for days must not grow.
#include <gtest/gtest.h>

#include <memory>

#include "g2o/core/small_graph.h"

#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#define HAS_HEAP_STATISTICS
#endif

namespace {

void optimize_square(g2o::SparseOptimizer& optimizer) {
  small_graph::add_square(optimizer);
  ASSERT_TRUE(optimizer.initializeOptimization());
  ASSERT_GT(optimizer.optimize(3), 0);
}

TEST(Memory, DoesNotGrowOverManyCyclesOfOptimizeAndClear) {
#ifndef HAS_HEAP_STATISTICS
  GTEST_SKIP() << "the C library does not report the size of the heap, or a sanitizer replaces the heap";
#else
  constexpr int kWarmUp = 100, kCycles = 10000;
  g2o::SparseOptimizer kept;
  kept.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(small_graph::make_solver()));
  kept.setComputeBatchStatistics(true);
  size_t before = 0;
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    if (cycle == kWarmUp) before = mallinfo2().uordblks;
    optimize_square(kept);
    kept.clear();
    if (cycle % 10 != 0) continue;
    g2o::SparseOptimizer passing;
    passing.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(small_graph::make_solver()));
    optimize_square(passing);
  }
  EXPECT_LE(mallinfo2().uordblks, before + 4096);
#endif
}

}  // namespace
