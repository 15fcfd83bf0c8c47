// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/starts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "algorithm/levenberg_marquardt.h"
#include "guess/start_table.h"
#include "optimize/stuck.h"
#include "system/planned_system.h"
#include "system/whole_vector.h"

namespace boxplus {
namespace {

GuessResult guess_by(Start start, Graph& graph, const Plan& plan, const GuessLimits& limits) {
  for (const detail::StartEntry& entry : detail::start_table()) {
    if (entry.start == start && entry.guess != nullptr) return entry.guess(graph, plan, limits);
  }
  throw InvalidArgument("Options::start: expected one of the starts of the library, got " +
                        std::to_string(static_cast<int>(start)));
}

/// Estimates from which to run, their chi2, and the iterations that led to them.
struct StartingPoint {
  Start start = Start::kCurrent;
  Estimates estimates;
  double chi2 = 0;
  std::vector<IterationRecord> records;
};

/// A run and its result. Its final estimates are in the graph or in `estimates`.
struct Candidate {
  Start start = Start::kCurrent;
  RunResult result;
  std::vector<IterationRecord> records;
  Estimates estimates;

  /// Whether to keep this candidate rather than `other`.
  bool is_better_than(const Candidate& other) const {
    const auto rank = [](const RunResult& r) {
      return std::pair(r.status == Report::Status::kFailed, r.chi2);
    };
    return rank(result) < rank(other.result);
  }
};

/// Whether the first try of a step decreased chi2 by about the predicted amount. The ratio must be within the
/// bounds that trust-region methods call "very good". In this case, the quadratic model is accurate as far as
/// the minimum, so the estimates are in the valley (the basin of attraction) of this minimum.
bool keeps_prediction(const IterationRecord& step) {
  constexpr double kLeast = 0.75, kMost = 1.25;
  const double kept = step.chi2_decrease / step.predicted_decrease;
  return step.tries == 1 && kept >= kLeast && kept <= kMost;
}

/// Whether any active edge has a robust kernel. Robust kernels limit chi2 and flatten the quadratic model, so
/// neither chi2 nor the model shows how close a minimum is.
bool has_robust_kernels_here(const Graph& graph, const Plan& plan) {
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (pool.kernel(edge) != nullptr) return true;
    }
  }
  return false;
}

bool has_robust_kernels(Descent& descent) {
  return any(descent.system(), has_robust_kernels_here(descent.graph(), descent.system().plan()));
}

bool eliminates(Descent& descent) {
  return any(descent.system(), descent.system().plan().eliminated_blocks > 0);
}

/// Whether a run has converged although noise does not explain its chi2, and some of its edges may be stuck:
/// points are eliminated, and a few edges have most of chi2, or damping shortened the last step.
bool may_be_stuck(Descent& descent, const RunResult& result) {
  constexpr double kLarge = 1;  // λD is as large as H
  return result.status == Report::Status::kConverged && descent.may_go_on() &&
         descent.options().algorithm == AlgorithmKind::kAutomatic && eliminates(descent) &&
         !descent.is_plausible(result.chi2) &&
         (few_edges_dominate(descent.graph(), descent.system()) ||
          (!descent.records().empty() && descent.records().back().lambda > kLarge));
}

class StartSearch {
 public:
  StartSearch(Descent& descent, Report::StartReport& report, double& guess_seconds, StartMemory& memory,
              const MakeGuess& guess)
      : descent_(descent),
        guess_(guess),
        report_(report),
        guess_seconds_(guess_seconds),
        original_(memory.original),
        fallback_(memory.fallback),
        chi2_original_(report.chi2_current) {}

  RunResult run() {
    const Start start = descent_.options().start;
    if (is_automatic()) original_.take(graph(), plan());
    if (start == Start::kCurrent) return confirmed(run_current(chi2_original_));
    fallback_.take(graph(), plan());
    return confirmed(start == Start::kAutomatic ? run_automatically() : run_from_guess(start));
  }

 private:
  Graph& graph() { return descent_.graph(); }
  const Plan& plan() { return descent_.system().plan(); }

  /// Whether the algorithm and its damping are the library's choice.
  bool is_automatic() {
    const Options& options = descent_.options();
    return options.algorithm == AlgorithmKind::kAutomatic &&
           options.damping == Options::DampingScale::kDiagonal && options.initial_lambda == 0 &&
           options.initial_radius == 0;
  }

  /// The result, or a better one of a run from the original estimates if unknowns have lost their influence.
  RunResult confirmed(const RunResult& result) {
    const bool may_be_far =
        is_automatic() && !ran_carefully_ && !eliminates(descent_) && descent_.has_lost_influence();
    return may_be_far && !is_interruption(result.reason) && descent_.may_go_on() ? run_carefully(result)
                                                                                 : result;
  }

  /// Runs from the current estimates, which are the original ones or better ones. If a few edges are then
  /// stuck, also runs from the original estimates with D = I: this lets points near cameras move freely, but
  /// far points hardly move. Then continues from the better result.
  RunResult run_current(double chi2) {
    // Points are eliminated: a run far from the minimum may leave some of them behind cameras or at infinity.
    if (!is_automatic() || !eliminates(descent_)) return descent_.run(chi2);
    Crawl crawl;
    bool gave_up = false;
    RunResult result = descent_.run_while(
        [&](const IterationRecord& record) {
          gave_up = crawl.is_noticed(record.chi2) && is_stuck(record.chi2);
          return !gave_up;
        },
        chi2);
    if (is_interruption(result.reason) && !gave_up) return result;
    if (gave_up) result.reason = unfinished();
    if (!descent_.may_go_on() || !is_stuck(result.chi2)) return result;
    return run_carefully(result);
  }

  /// The reason why a run that gave up is at its end, if no other one follows.
  Report::Reason unfinished() {
    const bool is_over = any(descent_.system(), descent_.limit().raised());
    return is_over ? reason_of(descent_.limit()) : Report::Reason::kMaxIterations;
  }

  /// Runs again from the original estimates, by Levenberg-Marquardt with D = I. Then continues from the
  /// better result.
  RunResult run_carefully(const RunResult& result) {
    ran_carefully_ = true;
    StartingPoint again{Start::kCurrent, {}, chi2_original_, {}};
    std::swap(again.estimates, original_);
    LevenbergMarquardt careful;
    Algorithm& usual = descent_.algorithm();
    descent_.use(careful);
    descent_.damp_by(Options::DampingScale::kIdentity);
    const RunResult best = run_from_other(result, std::move(again), descent_.iterations_left());
    descent_.use(usual);
    descent_.damp_by(Options::DampingScale::kDiagonal);
    return is_interruption(best.reason) || !descent_.may_go_on() ? best : descent_.run(best.chi2);
  }

  bool is_stuck(double chi2) {
    return !descent_.is_plausible(chi2) && few_edges_dominate(graph(), descent_.system());
  }

  RunResult run_from_guess(Start start) {
    if (!make_guess(start)) return run_current(chi2_original_);
    report_.used = start;
    RunResult result = descent_.run(report_.chi2_guess);
    // A guess may be worse than the current estimates. If the run is stopped while its chi2 is still higher
    // than the chi2 of the current estimates, restores the current estimates.
    const bool stopped =
        result.reason == Report::Reason::kTimeLimit || result.reason == Report::Reason::kStopFlag;
    if (!stopped || !(result.chi2 > chi2_original_)) return result;
    fallback_.put_back(graph(), plan());
    report_.used = Start::kCurrent;
    descent_.discard_records();
    result.chi2 = chi2_original_;
    return result;
  }

  /// Runs from the current estimates if they seem to lie in the valley of the global minimum. Otherwise,
  /// makes a chordal guess, and runs from the better of the two starts. If the result is not plausible, also
  /// runs from the other start.
  RunResult run_automatically() {
    double chi2 = chi2_original_;
    if (std::isfinite(chi2) && descent_.options().max_iterations > 1 && !has_robust_kernels(descent_)) {
      bool gave_up = false;
      const RunResult result = try_current(gave_up);
      const bool is_good = result.status == Report::Status::kConverged && descent_.is_plausible(result.chi2);
      const bool may_go_on = !is_interruption(result.reason) && descent_.may_go_on();
      if (!gave_up) return is_good || !may_go_on ? result : compare_with_guess(result);
      if (result.chi2 < chi2) {
        fallback_.take(graph(), plan());
        chi2 = result.chi2;
      } else {
        fallback_.put_back(graph(), plan());
        descent_.discard_records();
      }
    }
    if (!make_guess(Start::kChordal)) return run_current(chi2);
    return run_from_better(chi2);
  }

  /// Runs from the current estimates. Gives up, with Report::Reason::kCallback, if the first step does not
  /// lower chi2 as predicted, or if the run does not converge within a few iterations. In the valley of the
  /// global minimum, Gauss-Newton converges that fast.
  RunResult try_current(bool& gave_up) {
    constexpr int kMostIterations = 9;
    const auto wanted = [&](const IterationRecord& step) {
      if (step.iteration == 1) {
        report_.first_step_kept = step.chi2_decrease / step.predicted_decrease;
        gave_up = !keeps_prediction(step);
      } else if (step.iteration == kMostIterations) {
        gave_up = true;
      }
      return !gave_up;
    };
    report_.used = Start::kCurrent;
    const RunResult result = descent_.run_while(wanted, chi2_original_);
    gave_up = gave_up && result.reason == Report::Reason::kCallback;
    return result;
  }

  /// Runs from the better of two starts. One is the chordal guess, which is in the graph. The other is
  /// fallback_, with the chi2 `chi2_current`; the records that lead to it are in place. The guess counts as
  /// better if its chi2 is below the chi2 of the original estimates. If the result is worse than the chi2 of
  /// the other start, also runs from the other start. With robust kernels, chi2 does not show which start is
  /// in the better valley, and runs need many iterations. So with robust kernels, the first run leaves half
  /// of the iterations for the second run.
  RunResult run_from_better(double chi2_current) {
    const double chi2_guess = report_.chi2_guess;
    const bool guess_first =
        std::isfinite(chi2_guess) && (chi2_guess < chi2_original_ || !std::isfinite(chi2_original_));
    StartingPoint other{Start::kCurrent, {}, chi2_current, {}};
    if (guess_first) {
      std::swap(other.estimates, fallback_);
      other.records = descent_.set_aside_records();
    } else {
      other = {Start::kChordal, Estimates(graph(), plan()), chi2_guess, {}};
      fallback_.put_back(graph(), plan());
    }
    report_.used = guess_first ? Start::kChordal : Start::kCurrent;
    const bool leaves_iterations = std::isfinite(other.chi2) && has_robust_kernels(descent_);
    const RunResult first =
        run_for(share_of_iterations(leaves_iterations), guess_first ? chi2_guess : chi2_current);
    const bool is_good = first.status == Report::Status::kConverged && !(first.chi2 > other.chi2);
    const bool may_go_on = !is_interruption(first.reason) && descent_.may_go_on();
    if (is_good || !may_go_on || !std::isfinite(other.chi2)) return first;
    const RunResult best = run_from_other(first, std::move(other), share_of_iterations(leaves_iterations));
    const bool is_unfinished = best.reason == Report::Reason::kMaxIterations && descent_.may_go_on();
    return is_unfinished ? descent_.run(best.chi2) : best;
  }

  /// The number of iterations for the next run. If the run has to leave iterations for another run, it gets
  /// half of the remaining iterations. Otherwise, it gets all of them.
  int share_of_iterations(bool leaves_iterations) const {
    const int left = descent_.iterations_left();
    return leaves_iterations ? (left + 1) / 2 : left;
  }

  /// Runs from the current estimates, for at most `most` iterations.
  RunResult run_for(int most, double chi2) {
    int left = most;
    RunResult result = descent_.run_while([&](const IterationRecord&) { return --left > 0; }, chi2);
    if (result.reason == Report::Reason::kCallback && left == 0)
      result.reason = Report::Reason::kMaxIterations;
    return result;
  }

  /// Called after a run from the current estimates, `first`, that may have ended in a local minimum. Also
  /// runs from the chordal guess, if there is one, and keeps the better result.
  RunResult compare_with_guess(const RunResult& first) {
    fallback_.take(graph(), plan());
    if (!make_guess(Start::kChordal)) return first;
    StartingPoint guess{Start::kChordal, Estimates(graph(), plan()), report_.chi2_guess, {}};
    fallback_.put_back(graph(), plan());
    return run_from_other(first, std::move(guess), descent_.iterations_left());
  }

  /// Runs from the other start, for at most `most` iterations. Keeps the better result of this run and the
  /// run that has just ended.
  RunResult run_from_other(const RunResult& first_result, StartingPoint other, int most) {
    const Candidate first{report_.used, first_result, std::exchange(descent_.records(), {}),
                          Estimates(graph(), plan())};
    other.estimates.put_back(graph(), plan());
    descent_.resume(std::move(other.records));
    const Candidate second{other.start, run_for(most, other.chi2), descent_.records(), {}};
    const bool keeps_second = second.is_better_than(first);
    const Candidate& better = keeps_second ? second : first;
    report_.ran_both = true;
    report_.chi2_other_final = keeps_second ? first.result.chi2 : second.result.chi2;
    report_.used = better.start;
    descent_.records() = better.records;
    better.estimates.put_back(graph(), plan());
    return better.result;
  }

  /// Replaces the estimates by the guess `start`, and evaluates its chi2. If no guess can be made (the report
  /// says why), or if there is no time left, restores fallback_ and returns false.
  bool make_guess(Start start) {
    if (try_guess(start)) return true;
    fallback_.put_back(graph(), plan());
    return false;
  }

  bool try_guess(Start start) {
    if (any(descent_.system(), descent_.limit().raised())) return false;
    if (any(descent_.system(), !plan().fixed_scalars.empty())) {
      report_.note = "no guess was made, because it would change fixed directions of vertices";
      return false;
    }
    if (descent_.system().has_bounds()) {
      report_.note = "no guess was made, because it might leave the bounds of vertices";
      return false;
    }
    {
      const ScopedTimer adder(guess_seconds_);
      const GuessLimits limits{descent_.limit(), descent_.options().max_factor_bytes,
                               resolved_threads(descent_.options()),
                               descent_.system().facts().elimination_order};
      const GuessResult guess = guess_ ? guess_(start, limits) : guess_by(start, graph(), plan(), limits);
      report_.note = guess.note;
      if (any(descent_.system(), !guess.made)) return false;
    }
    const double chi2 = descent_.system().chi2();
    if (descent_.system().stopped()) return false;
    report_.chi2_guess = chi2;
    return true;
  }

  Descent& descent_;
  const MakeGuess& guess_;
  Report::StartReport& report_;
  double& guess_seconds_;
  Estimates& original_;  // if is_automatic()
  Estimates& fallback_;  // the original estimates, or the result of try_current()
  bool ran_carefully_ = false;
  const double chi2_original_;  // the chi2 of the original estimates
};

}  // namespace

RunResult minimize_from_starts(Descent& descent, Report::StartReport& report, double& guess_seconds,
                               StartMemory& memory, const MakeGuess& guess) {
  constexpr double kNoticeable = 0.01;
  RunResult result = StartSearch(descent, report, guess_seconds, memory, guess).run();
  for (bool gains = true; gains && may_be_stuck(descent, result);) {
    // Whoever repeats the run must not gain noticeably.
    const double before = result.chi2;
    Report::StartReport again;
    again.chi2_current = before;
    std::vector<IterationRecord> records = std::exchange(descent.records(), {});
    result = StartSearch(descent, again, guess_seconds, memory, guess).run();
    for (IterationRecord& record : descent.records()) {
      record.iteration = static_cast<int>(records.size()) + 1;
      records.push_back(record);
    }
    descent.records() = std::move(records);
    gains = result.chi2 < (1 - kNoticeable) * before;
  }
  return result;
}

}  // namespace boxplus
