// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/growing_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>

namespace boxplus::viewer {
namespace {

TEST(GrowingPool, HasFewThreadsIfJobsComeOneAfterTheOther) {
  GrowingPool pool(50);
  for (int k = 0; k < 50; ++k) {
    std::promise<void> done;
    pool.enqueue([&] { done.set_value(); });
    done.get_future().wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // until the thread is idle again
  }
  EXPECT_LT(pool.threads(), 25U);  // 1, unless the machine is very busy
}

TEST(GrowingPool, HasAThreadForEachJobThatTakesLong) {
  GrowingPool pool(8);
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::promise<void> all_run;
  std::atomic<int> running = 0;
  for (int k = 0; k < 8; ++k) {
    pool.enqueue([&, ended] {
      if (++running == 8) all_run.set_value();
      ended.wait();
    });
  }
  all_run.get_future().wait();
  EXPECT_EQ(pool.threads(), 8U);
  std::promise<void> late;
  pool.enqueue([&] { late.set_value(); });
  EXPECT_EQ(pool.threads(), 8U);
  const std::future<void> is_late = late.get_future();
  EXPECT_EQ(is_late.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  end.set_value();
  is_late.wait();
}

TEST(GrowingPool, RunsTheJobsThatWaitBeforeItEnds) {
  std::atomic<int> count = 0;
  {
    GrowingPool pool(2);
    for (int k = 0; k < 1000; ++k) pool.enqueue([&] { ++count; });
  }
  EXPECT_EQ(count, 1000);
}

}  // namespace
}  // namespace boxplus::viewer
