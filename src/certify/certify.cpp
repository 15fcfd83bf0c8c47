// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stopwatch.h"
#include "boxplus/base/error.h"
#include "boxplus/base/parallel.h"
#include "boxplus/certify/certificate.h"
#include "boxplus/optimize/optimizer.h"
#include "certify/rounding.h"
#include "certify/search.h"
#include "graph/snapshot.h"
#include "guess/initial_guess.h"

namespace boxplus {
namespace {

using namespace certificate;

/// Two minima are the same if their chi2 differs by less than this fraction.
constexpr double kSame = 1e-6;

class Certifier {
 public:
  Certifier(Graph& graph, const CertificateOptions& options, const ChordalProblem& problem)
      : graph_(graph), options_(options), problem_(problem) {
    given_.take(graph);
    result_.relation = problem.relation;
    result_.chi2 = chi2();
  }

  Certificate run();

 private:
  StackedPoses find_chordal_minimum();
  StackedPoses chordal_guess(const Resources& resources);
  bool compare(const StackedPoses& poses);
  bool is_same_minimum(double found);
  void judge();
  double chi2() const;
  double optimized_chi2();
  void explain_missing_proof();

  Graph& graph_;
  const CertificateOptions& options_;
  const ChordalProblem& problem_;
  Stopwatch watch_;
  outliers::Snapshot given_;
  Certificate result_;
  bool is_global_ = false;  // whether F is within the tolerance of its bound
  double rounding_ = 0;     // how much rounding may change F
};

/// The chi2 of the current estimates with normalized quaternions.
double Certifier::chi2() const {
  if (problem_.relation == Certificate::Relation::kEqual) return problem_.cost(read_poses(graph_, problem_));
  double sum = 0;
  for (const EdgeRef& edge : problem_.refs) sum += graph_.chi2(edge);
  return sum;
}

/// Poses that do not depend on the given estimates.
StackedPoses Certifier::chordal_guess(const Resources& resources) {
  PlanRequest request;
  request.level = -1;
  request.edges = problem_.refs;
  request.threads = resources.threads;
  request.stop = resources.stop;
  const Plan plan = make_plan(graph_, request);
  static_cast<void>(guess_chordal(graph_, plan, {.stop = resources.stop, .threads = resources.threads}));
  StackedPoses poses = read_poses(graph_, problem_);
  given_.put_back(graph_);
  return poses;
}

StackedPoses Certifier::find_chordal_minimum() {
  const Options& options = options_.options;
  const Resources resources{options.threads > 0 ? options.threads : detail::hardware_threads(),
                            StopToken(options.stop, watch_.start(), options.time_limit_s)};
  Search search(problem_, read_poses(graph_, problem_), options_.tolerance, resources);
  const auto record = [&] {
    is_global_ = search.is_global();
    rounding_ = search.rounding();
    result_.chordal_cost = search.cost();
    result_.bound = std::min(search.bound().value_or(0), search.cost());
    result_.steps = search.steps();
    result_.escapes = search.escapes();
  };
  try {
    search.run(options_.max_escapes, [&] { return chordal_guess(resources); });
  } catch (const Stopped&) {
    record();
    throw;
  }
  record();
  return search.poses();
}

/// Minimizes chi2 from the current estimates.
double Certifier::optimized_chi2() {
  Options options = options_.options;
  options.start = Start::kCurrent;
  options.callback = {};
  options.noise_tolerance = 0;
  options.time_limit_s = std::max(0.0, options.time_limit_s - watch_.seconds());
  const Report report = optimize(graph_, options);
  const bool by_flag = report.reason == Report::Reason::kStopFlag;
  if (by_flag || report.reason == Report::Reason::kTimeLimit) throw Stopped(by_flag);
  return chi2();
}

/// Whether the given estimates lead to this chi2, too. The run that ended there may have stopped a little
/// earlier than optimized_chi2() does; then judge() refuses them.
bool Certifier::is_same_minimum(double found) {
  constexpr double kEarly = 1e-3;
  if (found >= result_.chi2 * (1 - kSame)) return true;
  if (found < result_.chi2 * (1 - kEarly)) return false;
  given_.put_back(graph_);
  return found >= optimized_chi2() * (1 - kSame);
}

/// Minimizes chi2 from the minimum of F. Returns whether this is a better minimum than the given one; then
/// the graph has its estimates.
bool Certifier::compare(const StackedPoses& poses) {
  result_.chi2_from_chordal = result_.chordal_cost;
  const bool is_chi2 = result_.relation == Certificate::Relation::kEqual;
  if (is_chi2 && result_.chordal_cost >= result_.chi2 * (1 - kSame)) return false;
  write_poses(poses, problem_, graph_);
  result_.chi2_from_chordal = optimized_chi2();
  outliers::Snapshot found;
  found.take(graph_);
  if (is_same_minimum(result_.chi2_from_chordal)) return false;
  found.put_back(graph_);
  return true;
}

/// Sets the note if F is not within the tolerance of its bound.
void Certifier::explain_missing_proof() {
  result_.note = "no better minimum was found";
  if (result_.bound > 0) {
    result_.note +=
        fmt::format(", and the {} cannot be lower than {:.10g}, but this is a relative {:.1e} lower",
                    result_.relation == Certificate::Relation::kEqual ? "chi2" : "chordal cost",
                    result_.bound, result_.relative_gap());
  }
  if (rounding_ > options_.tolerance * result_.chordal_cost)
    result_.note += ", and the digits of a double do not suffice for a proof";
}

void Certifier::judge() {
  const bool is_chi2 = result_.relation == Certificate::Relation::kEqual;
  const double lowest = is_chi2 ? result_.bound : result_.chi2_from_chordal;
  const double above = result_.chi2 - lowest;
  if (!is_global_) {
    explain_missing_proof();
  } else if (result_.chi2_from_chordal > result_.chi2 * (1 + kSame)) {
    result_.note = "a run from the global minimum of the chordal cost ends at a higher chi2";
  } else if (above > (is_chi2 ? options_.tolerance : kSame) * result_.chi2) {
    result_.note = fmt::format(
        "the estimates are next to the global minimum, but their chi2 is a relative {:.1e} above {:.10g}; "
        "a run from them with a smaller tolerance may end closer",
        above / result_.chi2, lowest);
  } else {
    result_.verdict = Certificate::Verdict::kGlobalMinimum;
  }
}

Certificate Certifier::run() {
  try {
    if (fits_exactly(problem_, read_poses(graph_, problem_))) {
      result_.verdict = Certificate::Verdict::kGlobalMinimum;
    } else if (compare(find_chordal_minimum())) {
      result_.verdict = Certificate::Verdict::kLocalMinimum;
      result_.better_chi2 = result_.chi2_from_chordal;
    } else {
      given_.put_back(graph_);
      judge();
    }
  } catch (const Stopped& stopped) {
    given_.put_back(graph_);
    result_.note = stopped.by_flag() ? "the search was stopped" : "the time limit was reached";
  }
  result_.time_s = watch_.seconds();
  return std::move(result_);
}

void check(const CertificateOptions& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    throw InvalidArgument("certify: expected a tolerance in (0, 1), got " +
                          std::to_string(options.tolerance));
  if (options.max_escapes < 0)
    throw InvalidArgument("certify: expected max_escapes ≥ 0, got " + std::to_string(options.max_escapes));
}

}  // namespace

std::string why_not_certifiable(const Graph& graph, const Options& options) {
  ChordalProblem problem;
  std::string complaint;
  read_problem(graph, options, problem, complaint);
  return complaint;
}

Certificate certify(Graph& graph, const CertificateOptions& options) {
  check(options);
  ChordalProblem problem;
  std::string complaint;
  if (!read_problem(graph, options.options, problem, complaint))
    throw InvalidArgument("certify: expected a graph of relative poses, but " + complaint);
  return Certifier(graph, options, problem).run();
}

}  // namespace boxplus
