// SPDX-License-Identifier: BSD-3-Clause
// Lets long computations check whether they should stop.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

#include "boxplus/base/abi.h"
#include "boxplus/base/error.h"

namespace boxplus {

/// The exception of computations that are stopped by a token and cannot return a status. optimize() catches
/// it and reports the reason.
class Stopped : public Error {
 public:
  explicit Stopped(bool by_flag)
      : Error(by_flag ? "stopped by a flag" : "stopped by a deadline"), by_flag_(by_flag) {}
  bool by_flag() const noexcept { return by_flag_; }

 private:
  bool by_flag_;
};

/// A token that is raised by a flag, by a deadline, or never. It is cheap to check, because it reads the
/// clock only if there is a deadline.
class StopToken {
 public:
  using Clock = std::chrono::steady_clock;

  /// A token that is never raised.
  StopToken() = default;
  /// A token that is raised while `*flag` is true, and from the time `begin` + `seconds` on. `flag` may be
  /// null; otherwise the flag must outlive the token.
  explicit StopToken(const std::atomic<bool>* flag, Clock::time_point begin = {}, double seconds = kUnlimited)
      : flag_(flag), deadline_(deadline(begin, seconds)) {}

  bool flag_raised() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }
  bool raised() const { return flag_raised() || (deadline_ != kNever && Clock::now() >= deadline_); }
  /// Throws Stopped if the token is raised.
  void check() const {
    if (raised()) throw Stopped(flag_raised());
  }
  /// Throws Stopped if the token is raised or the deadline is less than `seconds` away. Call it before a
  /// computation that takes this long and cannot be interrupted.
  void check_room_for(double seconds) const {
    check();
    if (deadline_ == kNever) return;
    if (std::chrono::duration<double>(deadline_ - Clock::now()).count() < seconds) throw Stopped(false);
  }

 private:
  static constexpr double kUnlimited = 1e9;  // seconds, about thirty years
  static constexpr Clock::time_point kNever = Clock::time_point::max();

  static Clock::time_point deadline(Clock::time_point begin, double seconds) {
    if (!(seconds < kUnlimited)) return kNever;
    const std::chrono::duration<double> limit(std::max(0.0, seconds));
    return begin + std::chrono::duration_cast<Clock::duration>(limit);
  }

  const std::atomic<bool>* flag_ = nullptr;
  Clock::time_point deadline_ = kNever;
};

}  // namespace boxplus
