// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/starts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxplus/optimize/initial_guess.h"

namespace boxplus {
namespace {

/// Overwrites the estimates with the initial guess `start`; false, with a note in the report, where there
/// is none.
bool make_guess(Run& run, Start start) {
  if (run.stop().raised()) return false;
  const TimeAdder adder(run.report().time.start_s);
  const GuessResult guess =
      start == Start::kOdometry ? guess_odometry(run.graph(), run.system().plan())
      : start == Start::kSpanningTree
          ? guess_spanning_tree(run.graph(), run.system().plan())
          : guess_chordal(run.graph(), run.system().plan(),
                          {run.stop(), run.options().max_factor_bytes, resolved_threads(run.options())});
  run.report().start.note = guess.note;
  return guess.made;
}

/// Exchanges the estimates with those saved at `level`.
void swap_with_saved(Run& run, int level) {
  run.system().save(VertexPool::kBestLevel);
  run.system().restore(level);
  for (const VertexList& list : run.system().plan().vertices) {
    run.graph().vertex_pools()[list.pool]->copy_backup(list.slots, VertexPool::kBestLevel, level);
  }
}

/// Runs from the estimates at kStartLevel too, and keeps the better result.
RunResult minimize_from_other(Run& run, const RunResult& first, double other_chi2) {
  run.report().start.ran_both = true;
  std::vector<IterationRecord> first_records = std::move(run.report().records);
  run.report().records.clear();
  swap_with_saved(run, VertexPool::kStartLevel);  // the first result waits there
  RunResult second = run.minimize(other_chi2);
  const auto rank = [](const RunResult& r) { return std::pair(r.status == Status::kFailed, r.chi2); };
  const bool keep_second = rank(second) < rank(first);
  run.report().start.chi2_other_final = keep_second ? first.chi2 : second.chi2;
  const Start other = run.report().start.used == Start::kChordal ? Start::kCurrent : Start::kChordal;
  if (keep_second) {
    run.report().start.used = other;
    return second;
  }
  run.system().restore(VertexPool::kStartLevel);
  run.report().records = std::move(first_records);
  return first;
}

/// Start::kAutomatic, with the chordal guess in the graph and the current estimates at kStartLevel.
RunResult minimize_from_better(Run& run) {
  const double chi2_guess = run.report().start.chi2_guess, chi2_current = run.report().chi2_initial;
  const bool guess_first = chi2_guess < chi2_current || !std::isfinite(chi2_current);
  if (!guess_first) swap_with_saved(run, VertexPool::kStartLevel);  // now the guess waits at kStartLevel
  run.report().start.used = guess_first ? Start::kChordal : Start::kCurrent;
  const RunResult first = run.minimize(std::min(chi2_guess, chi2_current));
  const double other_chi2 = guess_first ? chi2_current : chi2_guess;
  const bool good = first.status == Status::kConverged && !(first.chi2 > other_chi2);
  const bool may_go_on = !is_interruption(first.reason) && run.may_go_on();
  if (good || !may_go_on || !std::isfinite(other_chi2)) return first;
  return minimize_from_other(run, first, other_chi2);
}

}  // namespace

RunResult minimize_from_starts(Run& run) {
  if (run.options().start == Start::kCurrent) return run.minimize(run.report().chi2_initial);
  run.system().save(VertexPool::kStartLevel);
  const Start guess = run.options().start == Start::kAutomatic ? Start::kChordal : run.options().start;
  if (!make_guess(run, guess)) {
    run.system().restore(VertexPool::kStartLevel);
    return run.minimize(run.report().chi2_initial);
  }
  run.report().start.chi2_guess = run.system().chi2();
  run.report().start.used = guess;
  if (run.options().start != Start::kAutomatic) return run.minimize(run.report().start.chi2_guess);
  return minimize_from_better(run);
}

}  // namespace boxplus
