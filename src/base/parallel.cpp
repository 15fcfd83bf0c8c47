// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/parallel.h"

#include <atomic>
#include <cfenv>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "platform/process.h"

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace boxplus::detail {
namespace {

using Task = FunctionRef<void(int)>;

constexpr auto kSpin = std::chrono::microseconds(50);

/// True on a worker, and on the calling thread during its call. If a task calls parallel_tasks(),
/// that call uses no other threads.
thread_local bool inside_task = false;

void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#elif defined(__aarch64__)
  __asm__ __volatile__("isb");  // takes about as long as _mm_pause(); `yield` does nothing on most processors
#else
  std::this_thread::yield();
#endif
}

/// Waits until ready() returns true: spins for kSpin, and then sleeps on the condition variable.
template <class Ready>
void spin_then_sleep(std::mutex& mutex, std::condition_variable& wake, Ready ready) {
  const auto deadline = std::chrono::steady_clock::now() + kSpin;
  for (int spins = 0; !ready(); ++spins) {
    pause_briefly();
    if (spins % 64 == 63 && std::chrono::steady_clock::now() > deadline) {
      std::unique_lock lock(mutex);
      wake.wait(lock, ready);
      return;
    }
  }
}

/// Runs task(first) … task(last − 1) on this thread. If a task throws, still runs the remaining tasks, and
/// then returns the first exception.
std::exception_ptr run_here(const Task& task, int first, int last) noexcept {
  std::exception_ptr failure;
  for (int i = first; i < last; ++i) {
    try {
      task(i);
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  }
  return failure;
}

/// A thread that lives as long as the process, with a mailbox for one task at a time.
///
/// posted_, begun_ and done_ count the tasks. The owner posts the next task only after finish(). Whoever
/// raises begun_ to posted_ runs the task: the thread, or the owner. posted_ changes only under the mutex,
/// and so does done_ when the thread ends a task, so that a sleeping thread misses no change. A spinning
/// thread reads the counters without the mutex. Because the counters are atomic, a thread that reads a new
/// count also reads the new task_ or failure_.
class Worker {
 public:
  explicit Worker(int index) {
    std::thread([this, index] { loop(index); }).detach();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Starts the task.
  void post(const Task* task) {
    {
      std::lock_guard lock(mutex_);
      task_ = task;
      posted_.fetch_add(1);
    }
    wake_.notify_one();
  }

  /// Runs the posted task on this thread if it has not begun. Otherwise, waits until it has ended. Returns
  /// its exception, if any.
  std::exception_ptr finish(int index) {
    if (begin(posted_.load())) {
      std::exception_ptr failure = run_here(*task_, index, index + 1);
      done_.store(posted_.load());
      return failure;
    }
    spin_then_sleep(mutex_, finished_, [this] { return done_.load() == posted_.load(); });
    return std::exchange(failure_, nullptr);
  }

 private:
  [[noreturn]] void loop(int index) {
    inside_task = true;
    for (;;) {
      spin_then_sleep(mutex_, wake_, [this] { return posted_.load() != begun_.load(); });
      const unsigned count = posted_.load();
      if (!begin(count)) continue;
      failure_ = run_here(*task_, index, index + 1);
      {
        std::lock_guard lock(mutex_);
        done_.store(count);
      }
      finished_.notify_one();
    }
  }

  /// Whether this call is the first to begin the task with this number.
  bool begin(unsigned count) {
    unsigned before = count - 1;
    return begun_.compare_exchange_strong(before, count);
  }

  std::mutex mutex_;
  std::condition_variable wake_, finished_;
  const Task* task_ = nullptr;
  std::exception_ptr failure_;
  std::atomic<unsigned> posted_{0}, begun_{0}, done_{0};
};

class Pool {
 public:
  void run(int count, const Task& task) {
    std::lock_guard one_caller(callers_);
    const int forked = grow_to(count - 1);
    for (int i = 1; i <= forked; ++i) worker(i).post(&task);
    inside_task = true;
    std::exception_ptr failure = run_here(task, 0, 1);
    std::exception_ptr unforked = run_here(task, forked + 1, count);
    for (int i = 1; i <= forked; ++i) {
      std::exception_ptr theirs = worker(i).finish(i);
      if (!failure) failure = std::move(theirs);
    }
    inside_task = false;
    if (!failure) failure = std::move(unforked);
    if (failure) std::rethrow_exception(std::move(failure));
  }

 private:
  /// Starts workers until there are `count` of them, or until the system refuses to start another thread.
  /// Returns the number of workers to use.
  int grow_to(int count) {
    workers_.reserve(static_cast<std::size_t>(count));
    try {
      while (static_cast<int>(workers_.size()) < count) {
        workers_.push_back(std::make_unique<Worker>(static_cast<int>(workers_.size()) + 1));
      }
    } catch (const std::system_error&) {
      return static_cast<int>(workers_.size());
    }
    return count;
  }

  Worker& worker(int index) { return *workers_[index - 1]; }

  std::mutex callers_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

/// The pool of this process. It is never destroyed, because destructors of global objects may use it. A
/// forked child process has none of its parent's threads, so it creates a new pool and abandons its copy of
/// the parent's pool.
Pool& pool() {
  static Pool* instance = [] {
    after_fork([] { instance = new Pool(); });
    return new Pool();
  }();
  return *instance;
}

}  // namespace

int hardware_threads() noexcept {
  const unsigned count = std::thread::hardware_concurrency();
  return count == 0 ? 1 : static_cast<int>(count);
}

void parallel_tasks(int count, FunctionRef<void(int)> task) {
  if (count > 1 && !inside_task) {
    std::fenv_t mode;
    std::fegetenv(&mode);
    pool().run(count, [&](int i) {
      std::fesetenv(&mode);
      task(i);
    });
  } else if (std::exception_ptr failure = run_here(task, 0, count)) {
    std::rethrow_exception(std::move(failure));
  }
}

}  // namespace boxplus::detail
