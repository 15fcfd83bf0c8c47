// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/growing_pool.h"

#include <system_error>
#include <utility>

namespace boxplus::viewer {

GrowingPool::GrowingPool(std::size_t most) : most_(most) {
  threads_.reserve(most_);
  threads_.emplace_back([this] { work(); });
}

std::size_t GrowingPool::threads() const {
  const std::lock_guard lock(mutex_);
  return threads_.size();
}

void GrowingPool::enqueue(std::function<void()> job) {
  const std::lock_guard lock(mutex_);
  jobs_.push_back(std::move(job));
  if (jobs_.size() > idle_ && threads_.size() < most_) {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // The job waits for another thread.
    }
  }
  has_job_.notify_one();
}

void GrowingPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    ++idle_;
    has_job_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
    --idle_;
    if (jobs_.empty()) return;
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
}

void GrowingPool::shutdown() {
  std::vector<std::thread> threads;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    threads.swap(threads_);
  }
  has_job_.notify_all();
  for (std::thread& thread : threads) thread.join();
}

}  // namespace boxplus::viewer
