// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/optimizer.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/diagnose/diagnose.h"
#include "boxplus/options/option_table.h"
#include "covariance/covariance_references.h"
#include "covariance/covariance_system.h"
#include "linearize/stiff_edge.h"
#include "optimize/constraints.h"
#include "optimize/fill_report.h"
#include "optimize/finish_stiff.h"
#include "optimize/starts.h"
#include "system/planned_system.h"

namespace boxplus {
namespace {

bool needs_diagnosis(const Report& report) {
  using enum Report::Reason;
  return report.status == Report::Status::kFailed || report.reason == kNoStepFound ||
         report.reason == kRaisedChi2 || report.reason == kRejectedEdges || report.reason == kWeightSpan;
}

/// Whether chi2 is so high that points may be on the wrong sides of cameras.
bool may_have_points_behind(const Report& report) {
  constexpr double kMost = 4;  // as in Report::chi2_remark()
  return report.converged() && report.eliminated > 0 && report.chi2_per_degree() > kMost;
}

/// Throws if the optimizer has no `impl`, because it was moved from.
template <class Impl>
Impl& checked(const std::unique_ptr<Impl>& impl) {
  if (!impl) throw InvalidArgument("Optimizer: it was moved from; use the Optimizer to which it was moved");
  return *impl;
}

/// Marks a graph as being optimized during the lifetime of this object. Throws if the graph is already
/// marked.
class InUse {
 public:
  explicit InUse(std::shared_ptr<detail::LifeState> life) : life_(std::move(life)) {
    if (life_->is_in_use)
      throw InvalidArgument(
          "Optimizer: this graph is being optimized; callbacks and error functions must not optimize it");
    life_->is_in_use = true;
  }
  ~InUse() { life_->is_in_use = false; }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  std::shared_ptr<detail::LifeState> life_;
};

}  // namespace

struct Optimizer::Impl {
  Impl(Graph& observed, Options initial)
      : graph(&observed), life(observed.life()), options(std::move(initial)) {}

  /// Runs `custom` or, if it is null, the algorithm that the options name.
  void run(Algorithm* custom, Report& report);
  RunResult plan_and_minimize(Algorithm* custom, Report& report, RunStop& stop, const Stopwatch& clock);
  RunResult minimize_with(Constraints& constraints, Algorithm& algorithm, Report& report, RunStop& stop,
                          const Stopwatch& clock);
  RunResult minimize(Algorithm& algorithm, const Options& of_run, Report& report, RunStop& stop,
                     const Stopwatch& clock);
  Algorithm& chosen_algorithm();
  Covariance covariance(std::span<const VertexRef> vertices, bool joint);
  Graph& checked_graph() const;

  Graph* graph;
  std::shared_ptr<detail::LifeState> life;  // tells whether `graph` still exists
  Options options;
  PlannedSystem planned;
  CovarianceSystem covariances;  // may use the plan of `planned`
  StartMemory memory;
  EdgeCounter counter;
  std::map<AlgorithmKind, std::unique_ptr<Algorithm>> algorithms;
};

Graph& Optimizer::Impl::checked_graph() const {
  if (life->is_over)
    throw InvalidArgument(
        "Optimizer: its graph was moved, assigned to or destroyed; make a new Optimizer for the graph");
  return *graph;
}

Algorithm& Optimizer::Impl::chosen_algorithm() {
  AlgorithmKind kind = options.algorithm;
  if (kind == AlgorithmKind::kAutomatic) {
    // Bounds turn the path of dogleg, but not the steps of Levenberg-Marquardt, which are computed with them.
    const BatchSystem& system = planned.system();
    const bool damps = system.plan().eliminated_blocks > 0 || system.has_bounds();
    kind = damps ? AlgorithmKind::kLevenbergMarquardt : AlgorithmKind::kDogleg;
  }
  std::unique_ptr<Algorithm>& algorithm = algorithms[kind];
  if (!algorithm) algorithm = make_algorithm(kind);
  return *algorithm;
}

void Optimizer::Impl::run(Algorithm* custom, Report& report) {
  const Stopwatch clock;
  checked_graph();
  detail::check_options(options);
  const InUse in_use(life);
  begin_report(report, options);
  RunStop stop(options, clock.start());
  try {
    const RunResult result = plan_and_minimize(custom, report, stop, clock);
    finish_report(report, *graph, planned.system(), result);
  } catch (const Stopped& stopped) {
    finish_report_without_plan(report, stopped);
    if (Constraints::exist_in(*graph))
      report.constraint_violation = std::numeric_limits<double>::quiet_NaN();  // not evaluated
  }
  const bool needs_all = needs_diagnosis(report);
  if (needs_all || may_have_points_behind(report)) {
    Options rest = options;
    rest.time_limit_s -= clock.seconds();
    report.findings = diagnose(*graph, rest).findings;
    if (!needs_all) {
      std::erase_if(report.findings, [](const detail::Finding& finding) {
        return finding.kind != detail::Finding::Kind::kBehindCameras;
      });
    }
  }
  report.time.total_s = clock.seconds();
}

RunResult Optimizer::Impl::plan_and_minimize(Algorithm* custom, Report& report, RunStop& stop,
                                             const Stopwatch& clock) {
  {
    const ScopedTimer adder(report.time.plan_s);
    if (!planned.is_current(*graph, options)) covariances.forget();
    report.plan_reused = planned.update(*graph, options, stop.now());
  }
  planned.system().configure(options, report.time, stop.now());
  Algorithm& algorithm = custom != nullptr ? *custom : chosen_algorithm();
  report.algorithm = algorithm.name();
  describe_problem(report, *graph, planned.system(), options, counter);
  report.chi2_initial = report.start.chi2_current = planned.system().chi2();
  Constraints constraints(*graph, planned.system().plan());
  if (constraints.empty()) return minimize(algorithm, options, report, stop, clock);
  return minimize_with(constraints, algorithm, report, stop, clock);
}

/// Runs until the constraints hold. Each run starts at the result of the previous one.
RunResult Optimizer::Impl::minimize_with(Constraints& constraints, Algorithm& algorithm, Report& report,
                                         RunStop& stop, const Stopwatch& clock) {
  Options of_round = options;
  constraints.begin(report.chi2_initial);
  for (;;) {
    report.start.chi2_current = planned.system().chi2();
    RunResult result = minimize(algorithm, of_round, report, stop, clock);
    const bool ends = is_interruption(result.reason) || result.status == Report::Status::kFailed;
    const bool goes_on = constraints.improve() && !ends;
    if (!goes_on) {
      constraints.report(report);
      report.start.chi2_current = report.chi2_initial;
      if (ends || constraints.hold()) return result;
      return {Report::Status::kNotConverged, Report::Reason::kConstraints, result.chi2, result.iterations};
    }
    of_round.start = Start::kCurrent;
  }
}

/// The chi2 at the current estimates must be report.start.chi2_current.
RunResult Optimizer::Impl::minimize(Algorithm& algorithm, const Options& of_run, Report& report,
                                    RunStop& stop, const Stopwatch& clock) {
  BatchSystem& system = planned.system();
  const double chi2 = report.start.chi2_current;
  if (system.stopped()) return {Report::Status::kNotConverged, reason_of(stop.now()), chi2, 0};
  if (system.plan().scalars() == 0)
    return {Report::Status::kConverged, Report::Reason::kNothingToOptimize, chi2, 0};
  if (options.gauge == GaugePolicy::kError && system.is_free())
    return {Report::Status::kFailed, Report::Reason::kGaugeFreedom, chi2, 0};
  Descent descent(*graph, system, algorithm, of_run, stop, clock, report);
  const bool may_be_stiff = information_is_stiff(*graph, system.plan());
  if (may_be_stiff) descent.leave(iterations_to_finish(options));
  RunResult result = minimize_from_starts(descent, report.start, report.time.start_s, memory);
  if (may_be_stiff || system.precise_steps() > 0)
    result = finish_stiff(descent, algorithm, result, memory.fallback);
  report.iterations = static_cast<int>(report.records.size());
  report.start.other_iterations = descent.iterations() - report.iterations;
  report.regularized_steps = descent.regularized_steps();
  report.precise_steps = system.precise_steps();
  report.displaced_directions = descent.displaced_directions();
  if (system.has_bounds() && !system.stopped() && system.linearize())
    system.report_bounds(report.active_bounds);
  return result;
}

Covariance Optimizer::Impl::covariance(std::span<const VertexRef> vertices, bool joint) {
  checked_graph();
  const BatchSystem* current = planned.is_current(*graph, options) ? &planned.system() : nullptr;
  return covariance_of_system(covariances, *graph, options, current, vertices, joint).covariance;
}

Optimizer::Optimizer(Graph& graph, Options options)
    : impl_(std::make_unique<Impl>(graph, std::move(options))) {}
Optimizer::~Optimizer() = default;
Optimizer::Optimizer(Optimizer&&) noexcept = default;
Optimizer& Optimizer::operator=(Optimizer&&) noexcept = default;

const Options& Optimizer::options() const {
  return checked(impl_).options;
}

void Optimizer::set_options(Options options) {
  checked(impl_).options = std::move(options);
}

void Optimizer::run(Report& report) {
  checked(impl_).run(nullptr, report);
}

void Optimizer::run(Algorithm& algorithm, Report& report) {
  checked(impl_).run(&algorithm, report);
}

Report Optimizer::run() {
  Report report;
  run(report);
  return report;
}

Report Optimizer::run(Algorithm& algorithm) {
  Report report;
  run(algorithm, report);
  return report;
}

Covariance Optimizer::covariance(std::span<const VertexRef> vertices) const {
  return checked(impl_).covariance(vertices, true);
}

Covariance Optimizer::marginal_covariances(std::span<const VertexRef> vertices) const {
  return checked(impl_).covariance(vertices, false);
}

Report optimize(Graph& graph, const Options& options) {
  return Optimizer(graph, options).run();
}

}  // namespace boxplus
