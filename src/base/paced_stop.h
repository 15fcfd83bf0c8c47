// SPDX-License-Identifier: BSD-3-Clause
// Checks a StopToken inside tight loops.
#pragma once

#include <cstdint>

#include "boxplus/base/stop_token.h"

namespace boxplus {

/// Checks a token only once in `steps` steps, because a check is slow; all other steps cost only a
/// subtraction and a branch. If a step takes about 50 ns (one or two cache misses), the default of 1024 steps
/// means a check about every 50 µs.
class PacedStop {
 public:
  static constexpr std::int64_t kSteps = 1024;
  explicit PacedStop(const StopToken& token, std::int64_t steps = kSteps)
      : token_(token), steps_(steps), left_(steps) {}

  /// Throws Stopped if a check is due and the token is raised.
  void step(std::int64_t count = 1) {
    if (is_due(count)) token_.check();
  }
  /// Returns true if a check is due and the token is raised. Does not throw.
  bool is_raised_after(std::int64_t count = 1) { return is_due(count) && token_.raised(); }

 private:
  bool is_due(std::int64_t count) {
    left_ -= count;
    if (left_ > 0) return false;
    left_ = steps_;
    return true;
  }

  const StopToken& token_;
  std::int64_t steps_, left_;
};

}  // namespace boxplus
