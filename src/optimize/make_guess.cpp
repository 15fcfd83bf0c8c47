// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/make_guess.h"

#include "boxplus/optimize/initial_guess.h"

namespace boxplus {

bool make_guess(Run& run, Start start) {
  if (run.stop().raised()) return false;
  if (!run.system().plan().fixed_scalars.empty()) {
    run.report().start.note = "guesses do not keep the directions in which vertices are fixed";
    return false;
  }
  const TimeAdder adder(run.report().time.start_s);
  const GuessResult guess =
      start == Start::kOdometry ? guess_odometry(run.graph(), run.system().plan())
      : start == Start::kSpanningTree
          ? guess_spanning_tree(run.graph(), run.system().plan())
          : guess_chordal(run.graph(), run.system().plan(),
                          {run.stop(), run.options().max_factor_bytes, resolved_threads(run.options()),
                           run.system().elimination_order()});
  run.report().start.note = guess.note;
  return guess.made;
}

}  // namespace boxplus
