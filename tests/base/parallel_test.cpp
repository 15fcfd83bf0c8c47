// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/parallel.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "sanitized.h"
namespace boxplus {
namespace {

using testing::Each;
using testing::ElementsAre;

/// The thread of each task. If `is_patient` is true, the first task ends only when all others have begun (or
/// after ten seconds), so that the caller takes none from the workers.
std::vector<std::thread::id> threads_of_tasks(int count, bool is_patient = true) {
  std::vector<std::thread::id> ids(static_cast<std::size_t>(count));
  std::atomic<int> begun{0};
  detail::parallel_tasks(count, [&](int i) {
    ids[static_cast<std::size_t>(i)] = std::this_thread::get_id();
    ++begun;
    for (int wait = 0; is_patient && i == 0 && begun < count && wait < 10000; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  return ids;
}

/// The number of times that each task of one call runs.
std::vector<int> runs_of_tasks(int count) {
  std::vector<int> runs(static_cast<std::size_t>(count));
  detail::parallel_tasks(count, [&](int i) { ++runs[static_cast<std::size_t>(i)]; });
  return runs;
}

/// Runs `count` tasks. Each task throws its index if the index is at least `first`. Returns the index that
/// parallel_tasks() throws, or -1 if it throws nothing.
int index_thrown(int count, int first) {
  try {
    detail::parallel_tasks(count, [&](int i) {
      if (i >= first) throw i;
    });
  } catch (int index) {
    return index;
  }
  return -1;
}

TEST(HardwareThreads, AreAtLeastOne) {
  EXPECT_GE(detail::hardware_threads(), 1);
}

TEST(ParallelTasks, RunEachTaskOnce) {
  for (int count : {0, 1, 2, 3, 8, 17}) {
    EXPECT_EQ(runs_of_tasks(count).size(), static_cast<std::size_t>(count));
    EXPECT_THAT(runs_of_tasks(count), Each(1));
  }
}

TEST(ParallelTasks, RunNothingForANegativeCount) {
  detail::parallel_tasks(-1, [](int) { FAIL(); });
}

TEST(ParallelTasks, RunOnDifferentThreadsAndTheFirstTaskRunsOnTheCallingThread) {
  const auto ids = threads_of_tasks(6);
  EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), 6U);
  EXPECT_EQ(ids[0], std::this_thread::get_id());
}

TEST(ParallelTasks, RunOnTheSameThreadsInEveryCall) {
  const auto six = threads_of_tasks(6);
  const auto four = threads_of_tasks(4);
  EXPECT_TRUE(std::equal(four.begin(), four.end(), six.begin()));
  EXPECT_EQ(threads_of_tasks(6), six);
}

TEST(ParallelTasks, ThatNoWorkerHasBegunRunOnTheCallingThread) {
  int taken = 0;
  for (int call = 0; call < 50; ++call) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // so that the workers sleep
    const auto ids = threads_of_tasks(4, false);
    taken += static_cast<int>(std::count(ids.begin() + 1, ids.end(), ids[0]));
  }
  EXPECT_GT(taken, 0);
  EXPECT_EQ(std::ranges::count(threads_of_tasks(4), std::this_thread::get_id()), 1);
}

TEST(ParallelTasks, HaveAllFinishedWhenTheCallReturns) {
  std::array<int, 5> sums{};
  for (int call = 0; call < 20000; ++call) {
    const int count = 1 + call % 5;
    detail::parallel_tasks(count, [&](int i) { ++sums[static_cast<std::size_t>(i)]; });
  }
  EXPECT_THAT(sums, ElementsAre(20000, 16000, 12000, 8000, 4000));
}

TEST(ParallelTasks, WakeSleepingWorkers) {
  for (int call = 0; call < 20; ++call) {
    EXPECT_THAT(runs_of_tasks(4), Each(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(ParallelTasks, WaitForATaskThatRunsLongerThanTheCallerSpins) {
  std::vector<int> slept(3);
  detail::parallel_tasks(3, [&](int i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5 * i));
    slept[static_cast<std::size_t>(i)] = 1;
  });
  EXPECT_THAT(slept, Each(1));
}

TEST(ParallelTasks, RunInOrderOnTheCallingThreadIfTheCallIsNested) {
  std::array<std::vector<int>, 4> orders;
  std::atomic<int> strays{0};
  detail::parallel_tasks(4, [&](int outer) {
    const auto here = std::this_thread::get_id();
    detail::parallel_tasks(3, [&](int inner) {
      orders[static_cast<std::size_t>(outer)].push_back(inner);
      if (std::this_thread::get_id() != here) ++strays;
    });
  });
  EXPECT_THAT(orders, Each(ElementsAre(0, 1, 2)));
  EXPECT_EQ(strays, 0);
}

TEST(ParallelTasks, RunOnSeveralThreadsAgainAfterNestedAndThrowingCalls) {
  detail::parallel_tasks(2, [](int) { detail::parallel_tasks(2, [](int) {}); });
  EXPECT_EQ(index_thrown(2, 0), 0);
  EXPECT_NE(threads_of_tasks(2)[1], std::this_thread::get_id());
}

TEST(ParallelTasks, RethrowTheExceptionOfTheTaskWithTheLowestIndex) {
  EXPECT_EQ(index_thrown(4, 4), -1);
  for (int first = 3; first >= 0; --first) EXPECT_EQ(index_thrown(4, first), first);
  EXPECT_EQ(index_thrown(1, 0), 0);
}

TEST(ParallelTasks, RethrowTheExceptionOfTheTaskWithTheLowestIndexFromNestedCalls) {
  std::array<int, 3> thrown{};
  detail::parallel_tasks(3, [&](int i) { thrown[static_cast<std::size_t>(i)] = index_thrown(4, i); });
  EXPECT_THAT(thrown, ElementsAre(0, 1, 2));
}

TEST(ParallelTasks, AllRunEvenIfSomeThrow) {
  const auto count_runs = [](std::atomic<int>& runs) {
    try {
      detail::parallel_tasks(4, [&](int) {
        ++runs;
        throw std::runtime_error("each");
      });
    } catch (const std::runtime_error&) {
    }
  };
  std::atomic<int> outer{0}, nested{0};
  count_runs(outer);
  detail::parallel_tasks(2, [&](int i) {
    if (i == 1) count_runs(nested);
  });
  EXPECT_EQ(outer, 4);
  EXPECT_EQ(nested, 4);
}

TEST(ParallelTasks, ForgetTheExceptionOfAnEarlierCall) {
  EXPECT_EQ(index_thrown(4, 0), 0);
  EXPECT_EQ(index_thrown(4, 4), -1);
}

TEST(ParallelTasks, ServeSeveralCallersAtOnce) {
  std::vector<long> sums(4);
  std::vector<std::thread> callers;
  callers.reserve(sums.size());
  for (auto& sum : sums) {
    callers.emplace_back([&sum] {
      for (int call = 0; call < 500; ++call) {
        const auto runs = runs_of_tasks(3);
        sum += std::accumulate(runs.begin(), runs.end(), 0L);
      }
    });
  }
  for (auto& caller : callers) caller.join();
  EXPECT_THAT(sums, Each(1500));
}

// Sanitizers support neither fork() in a program with several threads nor a tight limit of the address space.
#ifndef BOXPLUS_SANITIZED
TEST(ParallelTasks, RunInAForkedChildProcess) {
  detail::parallel_tasks(4, [](int) {});
  const pid_t child = fork();
  if (child == 0) _exit(runs_of_tasks(4) == std::vector<int>(4, 1) ? 0 : 1);
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(ParallelTasks, RoundAsTheCaller) {
  std::array<int, 4> modes{};
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  detail::parallel_tasks(4, [&](int i) { modes[static_cast<std::size_t>(i)] = std::fegetround(); });
  std::fesetround(before);
  EXPECT_THAT(modes, Each(FE_UPWARD));
}

/// Limits the address space of the process, so that the stack of another thread does not fit.
void forbid_more_threads() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t limit = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (1U << 20);
  const rlimit limits{limit, limit};
  setrlimit(RLIMIT_AS, &limits);
}

TEST(ParallelTasksDeathTest, RunOnTheCallingThreadIfNoOtherThreadCanBeCreated) {
  if (is_emulated()) GTEST_SKIP() << "an emulated program cannot start itself again";
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto run_without_threads = [] {
    forbid_more_threads();
    const auto ids = threads_of_tasks(4, false);
    const bool all_here = std::set(ids.begin(), ids.end()) == std::set{std::this_thread::get_id()};
    std::exit(all_here && index_thrown(4, 2) == 2 ? 0 : 1);
  };
  EXPECT_EXIT(run_without_threads(), testing::ExitedWithCode(0), "");
}
#endif

/// A global object whose destructor runs tasks. The worker threads must still exist at that time.
struct RunsTasksAtTheEnd {
  ~RunsTasksAtTheEnd() {
    std::atomic<int> done = 0;
    detail::parallel_tasks(3, [&](int) { ++done; });
    if (done != 3) std::abort();
  }
} runs_tasks_at_the_end;

}  // namespace
}  // namespace boxplus
