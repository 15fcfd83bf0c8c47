// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/parallel.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace boxplus {
namespace {

constexpr auto kSpin = std::chrono::microseconds(50);

void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#else
  std::this_thread::yield();
#endif
}

/// Waits until ready() holds: spins for kSpin, then sleeps on the condition variable.
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

class Pool {
 public:
  ~Pool() {
    for (auto& worker : workers_) {
      worker->quit.store(true);
      worker->post(nullptr);
      worker->thread.join();
    }
  }

  void run(int count, const FunctionRef<void(int)>& task) {
    std::lock_guard one_caller(callers_);
    while (static_cast<int>(workers_.size()) < count - 1) {
      workers_.push_back(std::make_unique<Worker>(static_cast<int>(workers_.size()) + 1));
    }
    for (int i = 1; i < count; ++i) workers_[static_cast<std::size_t>(i - 1)]->post(&task);
    std::exception_ptr failure;
    try {
      inside_task = true;
      task(0);
    } catch (...) {
      failure = std::current_exception();
    }
    inside_task = false;
    for (int i = 1; i < count; ++i) {
      auto theirs = workers_[static_cast<std::size_t>(i - 1)]->wait();
      if (!failure) failure = theirs;
    }
    if (failure) std::rethrow_exception(failure);
  }

  static thread_local bool inside_task;

 private:
  /// One thread with a mailbox: `posted` counts the tasks given, `done` those finished.
  struct Worker {
    explicit Worker(int index) : thread([this, index] { loop(index); }) {}

    void post(const FunctionRef<void(int)>* next) {
      {
        std::lock_guard lock(mutex);
        task = next;
        posted.fetch_add(1);
      }
      wake.notify_one();
    }

    std::exception_ptr wait() {
      spin_then_sleep(mutex, finished, [this] { return done.load() == posted.load(); });
      return std::exchange(failure, nullptr);
    }

    void loop(int index) {
      inside_task = true;
      for (unsigned seen = 0;; ++seen) {
        spin_then_sleep(mutex, wake, [this, seen] { return posted.load() != seen; });
        if (quit.load()) return;
        try {
          (*task)(index);
        } catch (...) {
          failure = std::current_exception();
        }
        {
          std::lock_guard lock(mutex);
          done.fetch_add(1);
        }
        finished.notify_one();
      }
    }

    std::mutex mutex;
    std::condition_variable wake, finished;
    const FunctionRef<void(int)>* task = nullptr;
    std::exception_ptr failure;
    std::atomic<unsigned> posted{0}, done{0};
    std::atomic<bool> quit{false};
    std::thread thread;  // last: it uses the members above
  };

  std::mutex callers_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

thread_local bool Pool::inside_task = false;

Pool& pool() {
  static Pool instance;
  return instance;
}

}  // namespace

int hardware_threads() noexcept {
  const unsigned count = std::thread::hardware_concurrency();
  return count == 0 ? 1 : static_cast<int>(count);
}

void parallel_tasks(int count, FunctionRef<void(int)> task) {
  if (count <= 1 || Pool::inside_task) {
    for (int i = 0; i < count; ++i) task(i);
    return;
  }
  pool().run(count, task);
}

}  // namespace boxplus
