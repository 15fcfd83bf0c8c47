// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/starts.h"

#include "optimize/automatic_start.h"
#include "optimize/make_guess.h"

namespace boxplus {

RunResult minimize_from_starts(Run& run) {
  const Start start = run.options().start;
  if (start == Start::kCurrent) return run.minimize(run.report().chi2_initial);
  if (start == Start::kAutomatic) return minimize_automatically(run);
  run.system().save(VertexPool::kStartLevel);
  if (!make_guess(run, start)) {
    run.system().restore(VertexPool::kStartLevel);
    return run.minimize(run.report().chi2_initial);
  }
  run.report().start.chi2_guess = run.system().chi2();
  run.report().start.used = start;
  return run.minimize(run.report().start.chi2_guess);
}

}  // namespace boxplus
