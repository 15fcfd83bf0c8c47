// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

#include "boxplus/base/stop_token.h"

namespace boxplus {

class Stopwatch {
 public:
  using Clock = StopToken::Clock;
  Clock::time_point start() const { return start_; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  Clock::time_point start_ = Clock::now();
};

/// Adds the seconds between its construction and its destruction to a total.
class ScopedTimer {
 public:
  explicit ScopedTimer(double& total) : total_(total) {}
  ~ScopedTimer() { total_ += watch_.seconds(); }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

 private:
  double& total_;
  Stopwatch watch_;
};

}  // namespace boxplus
