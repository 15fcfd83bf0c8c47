// SPDX-License-Identifier: BSD-3-Clause
// How long computations learn that they are to end.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

#include "boxplus/base/abi.h"

namespace boxplus {

/// Raised by a flag, by a deadline, or never. Cheap to ask: the clock is only read where there is a deadline.
class StopToken {
 public:
  using Clock = std::chrono::steady_clock;

  /// Never raised.
  StopToken() = default;
  /// Raised while `*flag` is true (null: never), which must outlive the token, and from `seconds` after
  /// `begin` on.
  explicit StopToken(const std::atomic<bool>* flag, Clock::time_point begin = {}, double seconds = kUnlimited)
      : flag_(flag), deadline_(deadline(begin, seconds)) {}

  bool flag_raised() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }
  bool raised() const { return flag_raised() || (deadline_ != kNever && Clock::now() >= deadline_); }

 private:
  static constexpr double kUnlimited = 1e9;  // seconds, some thirty years
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
