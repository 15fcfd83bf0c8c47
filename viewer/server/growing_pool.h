// SPDX-License-Identifier: BSD-3-Clause
// Threads for the requests to the server.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace boxplus::viewer {

/// Runs jobs, the oldest first. A thread is started only when a job waits and no thread is idle, so that slow
/// clients delay no other client, and a server with one page has few threads. If the system gives no further
/// thread, jobs wait for those that there are.
class GrowingPool {
 public:
  /// Starts one thread. Throws std::system_error if that is impossible.
  explicit GrowingPool(std::size_t most);
  ~GrowingPool() { shutdown(); }
  GrowingPool(const GrowingPool&) = delete;
  GrowingPool& operator=(const GrowingPool&) = delete;

  void enqueue(std::function<void()> job);
  /// Runs the jobs that wait, and ends all threads. No job may be enqueued after it.
  void shutdown();
  std::size_t threads() const;

 private:
  void work();

  const std::size_t most_;
  mutable std::mutex mutex_;
  std::condition_variable has_job_;
  std::deque<std::function<void()>> jobs_;
  std::size_t idle_ = 0;
  bool ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace boxplus::viewer
