// SPDX-License-Identifier: BSD-3-Clause
// When a run of an Optimizer has to stop.
#pragma once

#include "boxplus/base/stop_token.h"
#include "boxplus/options/options.h"

namespace boxplus {

/// Until a step is accepted, only Options::stop ends a run. So a run with a time limit that is shorter than
/// an iteration makes progress, and repeated runs converge. A limit that is not positive applies at once.
class RunStop {
 public:
  RunStop(const Options& options, StopToken::Clock::time_point begin)
      : limit_(options.stop, begin, options.time_limit_s),
        now_(options.time_limit_s > 0 ? StopToken(options.stop) : limit_) {}

  /// The token that applies now. The reference remains valid.
  const StopToken& now() const { return now_; }
  /// The token with the time limit, for computations without which the run makes progress, too.
  const StopToken& limit() const { return limit_; }
  /// Call it when a step is accepted.
  void apply_limit() { now_ = limit_; }

 private:
  StopToken limit_, now_;
};

}  // namespace boxplus
