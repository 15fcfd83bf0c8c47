// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/make_guess.h"

#include "boxplus/optimize/initial_guess.h"

namespace boxplus {

namespace {

GuessResult guess_from(Run& run, Start start) {
  const GuessLimits limits{run.stop(), run.options().max_factor_bytes, resolved_threads(run.options()),
                           run.system().elimination_order()};
  const Plan& plan = run.system().plan();
  switch (start) {
    case Start::kOdometry:
      return guess_odometry(run.graph(), plan, limits);
    case Start::kSpanningTree:
      return guess_spanning_tree(run.graph(), plan, limits);
    default:
      return guess_chordal(run.graph(), plan, limits);
  }
}

}  // namespace

bool make_guess(Run& run, Start start) {
  if (run.stop().raised()) return false;
  if (!run.system().plan().fixed_scalars.empty()) {
    run.report().start.note = "guesses do not keep the directions in which vertices are fixed";
    return false;
  }
  {
    const TimeAdder adder(run.report().time.start_s);
    const GuessResult guess = guess_from(run, start);
    run.report().start.note = guess.note;
    if (!guess.made) return false;
  }
  const double chi2 = run.system().chi2();
  if (run.system().stopped()) return false;
  run.report().start.chi2_guess = chi2;
  return true;
}

}  // namespace boxplus
