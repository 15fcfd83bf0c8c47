// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/finish_stiff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithm/gauss_newton.h"
#include "algorithm/roughness.h"
#include "base/vector_math.h"
#include "linearize/stiff_edge.h"

namespace boxplus {
namespace {

/// If the undamped step decreases chi2 by less than this fraction, the estimates are at a minimum.
constexpr double kAtMinimum = 1e-6;
/// If it decreases chi2 by more than this fraction, further steps are worth their time.
constexpr double kWorthSteps = 1e-9;

/// Whether stiff edges may have caused this result.
bool may_be_stiff(const RunResult& result) {
  return result.status == Report::Status::kConverged || result.reason == Report::Reason::kMaxIterations ||
         result.reason == Report::Reason::kNoStepFound || result.reason == Report::Reason::kRaisedChi2 ||
         result.reason == Report::Reason::kNotPositiveDefinite;
}

RunResult not_converged(const RunResult& result, Report::Reason reason) {
  return {Report::Status::kNotConverged, reason, result.chi2, result.iterations};
}

class Finish {
 public:
  Finish(Descent& descent, Algorithm& algorithm, Estimates& memory)
      : descent_(descent), system_(descent.system()), algorithm_(algorithm), memory_(memory) {}

  RunResult run(const RunResult& result) {
    is_precise_ = system_.precise_steps() > 0 ||
                  find_stiff_edge(descent_.graph(), system_.plan(), system_.linearize_options(),
                                  kVeryStiffRatio, descent_.stop());
    RunResult best = result;
    double possible = possible_decrease(best.chi2);
    const bool cannot_judge = !is_precise_ && std::isinf(possible);
    const bool is_affordable = !is_precise_ || system_.affordable_precise_steps() > 0;
    if (possible > kWorthSteps && !cannot_judge && is_affordable && descent_.may_go_on()) {
      best = after_gauss_newton(best);
      possible = possible_decrease(best.chi2);
    }
    const bool is_open = best.status != Report::Status::kConverged && !is_interruption(best.reason);
    if (possible > kAtMinimum && is_open && descent_.may_go_on()) {
      best = after_other_iterations(best);
      if (!cannot_judge) possible = possible_decrease(best.chi2);
    }
    if (cannot_judge && !descent_.stop().raised()) return best;
    return judged(best, possible);
  }

 private:
  /// The decrease of chi2 that the undamped step predicts, as a fraction of chi2. 0 if chi2 has only rounding
  /// errors along this step. Infinite if there is no such step.
  double possible_decrease(double chi2) {
    system_.set_precise(is_precise_);
    std::vector<double> step(system_.plan().scalars());
    const bool is_solved = system_.linearize() && system_.solve({}, step).status == LinearStatus::kOk;
    if (!is_solved || !all_finite(step) || system_.damps_gauge())
      return std::numeric_limits<double>::infinity();
    const double decrease = -dot(system_.gradient(), step);
    if (decrease <= kExact * static_cast<double>(step.size())) return 0;
    return decrease > kWorthSteps * chi2 && is_rough(system_, step, decrease, chi2) ? 0 : decrease / chi2;
  }

  /// Takes Gauss-Newton steps, with half of the remaining iterations, but no more than are affordable. In the
  /// curved valley of a stiff row, such a step first raises chi2, so that algorithms that compare chi2 make
  /// little progress. If chi2 is higher in the end, restores the estimates.
  RunResult after_gauss_newton(const RunResult& before) {
    const Plan& plan = system_.plan();
    const std::size_t records = descent_.records().size();
    memory_.take(descent_.graph(), plan);
    GaussNewton gauss_newton;
    descent_.use(gauss_newton);
    const int left = descent_.iterations_left(), half = (left + 1) / 2;
    descent_.leave(left - (is_precise_ ? std::min(half, system_.affordable_precise_steps()) : half));
    const RunResult after = descent_.run(before.chi2);
    descent_.leave(0);
    if (after.chi2 <= before.chi2) return after;
    memory_.put_back(descent_.graph(), plan);
    descent_.records().resize(records);
    return before;
  }

  /// Continues with the algorithm of the run.
  RunResult after_other_iterations(const RunResult& before) {
    system_.set_precise(false);
    descent_.use(algorithm_);
    return descent_.run(before.chi2);
  }

  bool is_rounded() const {
    return find_rounded_edge(descent_.graph(), system_.plan(), system_.linearize_options()).has_value();
  }

  RunResult judged(const RunResult& best, double possible) const {
    const StopToken& stop = descent_.stop();
    if (stop.raised()) return not_converged(best, reason_of(stop));
    if (is_interruption(best.reason)) return best;
    if (possible <= kAtMinimum && is_precise_ && is_rounded())
      return not_converged(best, Report::Reason::kWeightSpan);
    if (possible <= kAtMinimum) {
      if (best.status == Report::Status::kConverged) return best;
      return {Report::Status::kConverged, Report::Reason::kNoFurtherDecrease, best.chi2, best.iterations};
    }
    if (best.reason == Report::Reason::kMaxIterations && std::isfinite(possible)) return best;
    return not_converged(best, is_precise_ ? Report::Reason::kWeightSpan : Report::Reason::kNoStepFound);
  }

  Descent& descent_;
  RunSystem& system_;
  Algorithm& algorithm_;
  Estimates& memory_;
  bool is_precise_ = false;
};

}  // namespace

RunResult finish_stiff(Descent& descent, Algorithm& algorithm, const RunResult& result, Estimates& memory) {
  descent.leave(0);
  const bool is_over = result.reason == Report::Reason::kMaxIterations && !descent.may_go_on();
  if (!may_be_stiff(result) || is_over || descent.stop().raised()) return result;
  return Finish(descent, algorithm, memory).run(result);
}

}  // namespace boxplus
