// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/starts.h"

#include "optimize/automatic_start.h"
#include "optimize/make_guess.h"

namespace boxplus {

namespace {

/// A guess may be worse than the estimates as they came, which are at kStartLevel. If there was no time to
/// get below these, they are put back.
RunResult unless_stopped_above_current(Run& run, RunResult result) {
  const double chi2_current = run.report().chi2_initial;
  const bool stopped = result.reason == Reason::kTimeLimit || result.reason == Reason::kStopFlag;
  if (!stopped || !(result.chi2 > chi2_current)) return result;
  run.system().restore(VertexPool::kStartLevel);
  run.report().start.used = Start::kCurrent;
  run.report().records.clear();
  result.chi2 = chi2_current;
  return result;
}

}  // namespace

RunResult minimize_from_starts(Run& run) {
  const Start start = run.options().start;
  if (start == Start::kCurrent) return run.minimize(run.report().chi2_initial);
  if (start == Start::kAutomatic) return minimize_automatically(run);
  run.system().save(VertexPool::kStartLevel);
  if (!make_guess(run, start)) {
    run.system().restore(VertexPool::kStartLevel);
    return run.minimize(run.report().chi2_initial);
  }
  run.report().start.used = start;
  return unless_stopped_above_current(run, run.minimize(run.report().start.chi2_guess));
}

}  // namespace boxplus
