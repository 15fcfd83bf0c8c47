// SPDX-License-Identifier: BSD-3-Clause
// A long search that has released Python's lock (GIL): find_outliers() and certify().
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>

#include "observer.h"
#include "options_object.h"

namespace boxplus::python {

/// A search in a thread of its own. The calling thread, which may be the only one that can handle signals,
/// looks for them meanwhile. It also calls the callback.
class Search {
 public:
  Search(GraphObject::Run& run, const OptionsObject& object)
      : observer_(run, object.callback), user_stop_(object.stop), stop_(is_stopped_by_user()) {}

  /// Releases Python's lock (GIL), and calls `function` with `options` that stop it and call the callback.
  template <class Function>
  auto run(Options& options, const Function& function) {
    options.stop = &stop_;
    if (observer_.has_callback())
      options.callback = [this](const IterationRecord& record) { return ask(record); };
    auto result = [&] {
      const py::gil_scoped_release release;
      auto future = std::async(std::launch::async, [&] {
        const Notifier at_end(*this);
        return function();
      });
      watch();
      return future.get();
    }();
    observer_.rethrow();
    return result;
  }

 private:
  /// Tells the calling thread that the search is over, also if it throws.
  class Notifier {
   public:
    explicit Notifier(Search& search) : search_(&search) {}
    ~Notifier() {
      const std::scoped_lock lock(search_->mutex_);
      search_->is_over_ = true;
      search_->changed_.notify_all();
    }
    Notifier(const Notifier&) = delete;
    Notifier& operator=(const Notifier&) = delete;

   private:
    Search* search_;
  };

  bool is_stopped_by_user() const { return user_stop_ && user_stop_->is_set; }

  /// Called by the search: the answer of the callback.
  bool ask(const IterationRecord& record) {
    std::unique_lock lock(mutex_);
    record_ = &record;
    changed_.notify_all();
    changed_.wait(lock, [this] { return record_ == nullptr; });
    return answer_;
  }
  /// Called by the calling thread: returns at the end of the search.
  void watch() {
    constexpr std::chrono::milliseconds kPeriod{20};
    std::unique_lock lock(mutex_);
    while (!is_over_) {
      changed_.wait_for(lock, kPeriod, [this] { return is_over_ || record_ != nullptr; });
      const IterationRecord* const record = record_;
      lock.unlock();
      bool go_on = !observer_.has_raised();
      if (go_on) go_on = record != nullptr ? observer_(*record) : observer_.check_signals();
      if (observer_.has_raised() || is_stopped_by_user()) stop_ = true;
      lock.lock();
      if (record == nullptr) continue;
      answer_ = go_on;
      record_ = nullptr;
      changed_.notify_all();
    }
  }

  Observer observer_;
  std::shared_ptr<StopFlag> user_stop_;
  std::atomic<bool> stop_;
  std::mutex mutex_;  // of the members below
  std::condition_variable changed_;
  const IterationRecord* record_ = nullptr;  // for which the search waits for an answer
  bool answer_ = true;
  bool is_over_ = false;
};

}  // namespace boxplus::python
