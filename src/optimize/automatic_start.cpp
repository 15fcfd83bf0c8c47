// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/automatic_start.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/make_guess.h"

namespace boxplus {
namespace {

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

/// From the chordal guess, in the graph, where its chi2 is lower than that of the estimates as they came;
/// else from those at kStartLevel, which are these or what they have become, with the given chi2. From the
/// other too, where the result disappoints.
RunResult minimize_from_better(Run& run, double chi2_current) {
  const double chi2_guess = run.report().start.chi2_guess, chi2_initial = run.report().chi2_initial;
  const bool guess_first =
      std::isfinite(chi2_guess) && (chi2_guess < chi2_initial || !std::isfinite(chi2_initial));
  if (!guess_first) swap_with_saved(run, VertexPool::kStartLevel);  // now the guess waits at kStartLevel
  run.report().start.used = guess_first ? Start::kChordal : Start::kCurrent;
  const RunResult first = run.minimize(guess_first ? chi2_guess : chi2_current);
  const double other_chi2 = guess_first ? chi2_current : chi2_guess;
  const bool good = first.status == Status::kConverged && !(first.chi2 > other_chi2);
  const bool may_go_on = !is_interruption(first.reason) && run.may_go_on();
  if (good || !may_go_on || !std::isfinite(other_chi2)) return first;
  return minimize_from_other(run, first, other_chi2);
}

/// A trust region's "very good", on either side: the model holds as far as the minimum, and so the estimates
/// lie in its valley.
bool keeps_promise(const IterationRecord& step) {
  constexpr double kLeast = 0.75, kMost = 1.25;
  const double kept = step.chi2_decrease / step.promise;
  return step.tries == 1 && kept >= kLeast && kept <= kMost;
}

/// Robust kernels bound chi2, and flatten the model: neither tells anything about a minimum then.
bool has_robust_kernels(Run& run) {
  for (const EdgeList& list : run.system().plan().edges) {
    const EdgePool& pool = *run.graph().edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (pool.kernel(edge) != nullptr) return true;
    }
  }
  return false;
}

/// Whether chi2 is what noise explains: a local minimum far from the best one is hardly so good.
bool is_plausible(Run& run, double chi2) {
  constexpr double kAtMost = 2;
  return chi2 <= std::max(1.0, kAtMost * run.degrees_of_freedom());
}

/// Runs from the current estimates; gives up, with Reason::kCallback, after a first step that does not do
/// what the model promises, or where it does not arrive soon: Gauss-Newton does, in the right valley.
RunResult try_current(Run& run, bool& gave_up) {
  constexpr int kSoon = 9;  // iterations
  const auto wanted = [&](const IterationRecord& step) {
    if (step.iteration == 0) {
      run.report().start.first_step_kept = step.chi2_decrease / step.promise;
      gave_up = !keeps_promise(step);
    } else if (step.iteration + 1 == kSoon) {
      gave_up = true;
    }
    return !gave_up;
  };
  run.report().start.used = Start::kCurrent;
  const RunResult result = run.minimize_while(wanted, run.report().chi2_initial);
  gave_up = gave_up && result.reason == Reason::kCallback;
  return result;
}

/// Puts the chordal guess into the graph. Where there is none, leaves the estimates as they are.
bool replace_by_guess(Run& run) {
  run.system().save(VertexPool::kBestLevel);
  if (make_guess(run, Start::kChordal)) return true;
  run.system().restore(VertexPool::kBestLevel);
  return false;
}

/// After a run from the current estimates that ended where it may be a local minimum: from the chordal guess
/// too, where there is one.
RunResult compare_with_guess(Run& run, const RunResult& first) {
  run.system().save(VertexPool::kStartLevel);
  if (!replace_by_guess(run)) return first;
  swap_with_saved(run, VertexPool::kStartLevel);  // now the guess waits at kStartLevel
  return minimize_from_other(run, first, run.report().start.chi2_guess);
}

}  // namespace

RunResult minimize_automatically(Run& run) {
  double chi2 = run.report().chi2_initial;
  run.system().save(VertexPool::kStartLevel);
  if (std::isfinite(chi2) && run.options().max_iterations > 1 && !has_robust_kernels(run)) {
    bool gave_up = false;
    const RunResult result = try_current(run, gave_up);
    const bool is_good = result.status == Status::kConverged && is_plausible(run, result.chi2);
    const bool may_go_on = !is_interruption(result.reason) && run.may_go_on();
    if (!gave_up) return is_good || !may_go_on ? result : compare_with_guess(run, result);
    if (result.chi2 < chi2) {
      run.system().save(VertexPool::kStartLevel);
      chi2 = result.chi2;
    } else {
      run.system().restore(VertexPool::kStartLevel);
      run.report().records.clear();
    }
  }
  if (!replace_by_guess(run)) return run.minimize(chi2);
  run.report().records.clear();
  return minimize_from_better(run, chi2);
}

}  // namespace boxplus
