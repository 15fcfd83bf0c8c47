// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/optimize.h"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "optimize/non_finite.h"
#include "optimize/run.h"
#include "optimize/starts.h"
#include "optimize/weight_span.h"

namespace boxplus {
namespace {

void check(const Options& options) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw InvalidArgument(std::string("Options: expected ") + what);
  };
  require(options.max_iterations >= 0, "max_iterations ≥ 0");
  require(options.threads >= 0, "threads ≥ 0");
  require(options.cost_tolerance >= 0, "cost_tolerance ≥ 0");
  require(options.noise_tolerance >= 0, "noise_tolerance ≥ 0");
  require(options.step_tolerance >= 0, "step_tolerance ≥ 0");
  require(options.gradient_tolerance >= 0, "gradient_tolerance ≥ 0");
  require(options.linear_tolerance > 0 && options.linear_tolerance < 1, "0 < linear_tolerance < 1");
  require(options.initial_lambda >= 0 && std::isfinite(options.initial_lambda),
          "a finite initial_lambda ≥ 0");
  require(options.initial_radius >= 0, "initial_radius ≥ 0");
  require(!std::isnan(options.time_limit_s), "a time_limit_s that is a number");
}

/// Empties the report without giving its memory back.
void reset(Report& report) {
  std::vector<IterationRecord> records = std::move(report.records);
  std::vector<EdgeJacobians> jacobians = std::move(report.jacobians);
  GaugeReport gauge = std::move(report.gauge);
  std::string message = std::move(report.message);
  report = Report();
  records.clear();
  jacobians.clear();
  gauge.held.clear();
  gauge.free.clear();
  message.clear();
  report.records = std::move(records);
  report.jacobians = std::move(jacobians);
  report.gauge = std::move(gauge);
  report.message = std::move(message);
}

/// F at the estimates as they are left; that of the run if there is no time to evaluate it again.
double final_chi2(Run& run, const RunResult& result) {
  const double chi2 = run.system().chi2();
  return run.system().stopped() ? result.chi2 : chi2;
}

void finish(Run& run, RunResult result) {
  // A minimum of what double precision kept of H is not one of the problem.
  std::optional<SwampingEdge> swamping;
  const bool may_be_swamped =
      result.status == Status::kConverged || result.reason == Reason::kMaxIterations ||
      result.reason == Reason::kNoStepFound || result.reason == Reason::kNotPositiveDefinite;
  if (may_be_swamped) swamping = find_swamping_edge(run);
  if (swamping)
    std::tie(result.status, result.reason) = std::pair(Status::kNotConverged, Reason::kWeightSpan);
  run.report().linear = run.system().linear_solver().statistics();
  run.report().gauge.held_directions = run.system().held_directions();
  if (!run.system().gauge_is_free()) run.report().gauge.free.clear();
  run.report().status = result.status;
  run.report().reason = result.reason;
  run.report().chi2_final = final_chi2(run, result);
  run.report().message.assign(to_string(result.reason));
  if (result.reason == Reason::kNotPositiveDefinite) {
    const VertexRef vertex = run.system().failed_vertex();
    run.report().message += ": the Hessian is singular or indefinite at vertex " +
                            std::to_string(run.graph().id(vertex)) + " (" +
                            std::string(run.graph().vertex_pools()[vertex.pool]->type_name()) +
                            "); nothing measures it in some direction";
  } else if (result.reason == Reason::kNotFinite) {
    run.report().message += ": " + describe_non_finite(run);
  } else if (swamping) {
    run.report().message += ": " + edge_text(run.graph(), swamping->edge) +
                            " leaves no digit of other edges at vertex " +
                            std::to_string(run.graph().id(swamping->vertex)) +
                            "; merge the vertices that it joins, or lower its Ω";
  }
  if (std::isnan(run.report().chi2_initial) && is_interruption(result.reason)) {
    run.report().message += " before chi2 was evaluated";
  }
  run.report().time.total_s = run.seconds();
}

/// The end of a run that was stopped while it planned. Its estimates are those of the last iteration, if
/// there was one: a plan that is changed later comes after a run.
void finish_without_plan(Run& run, const Stopped& stopped) {
  Report& report = run.report();
  report.status = Status::kNotConverged;
  report.reason = stopped.by_flag() ? Reason::kStopFlag : Reason::kTimeLimit;
  report.chi2_final = report.records.empty() ? report.chi2_initial : report.records.back().chi2;
  report.message.assign(to_string(report.reason)) += " while planning";
  if (std::isnan(report.chi2_initial)) report.message += ", before chi2 was evaluated";
  report.time.total_s = run.seconds();
}

RunResult minimize_problem(Run& run) {
  const double chi2 = run.report().chi2_initial;
  if (run.system().stopped()) return {Status::kNotConverged, reason_of(run.stop()), chi2, 0};
  const Plan& plan = run.system().plan();
  if (plan.scalars() == 0) return {Status::kConverged, Reason::kNothingToOptimize, chi2, 0};
  if (run.options().gauge == GaugePolicy::kError && run.system().is_free()) {
    return {Status::kFailed, Reason::kGaugeFreedom, chi2, 0};
  }
  return minimize_from_starts(run);
}

}  // namespace

void optimize(Graph& graph, const Options& options, Report& report) {
  check(options);
  reset(report);
  Run run(graph, options, report);
  try {
    run.prepare();
    finish(run, minimize_problem(run));
  } catch (const Stopped& stopped) {
    finish_without_plan(run, stopped);
  }
}

Report optimize(Graph& graph, const Options& options) {
  Report report;
  optimize(graph, options, report);
  return report;
}

}  // namespace boxplus
