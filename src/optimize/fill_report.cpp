// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/fill_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/vector_math.h"
#include "linearize/non_finite.h"
#include "linearize/stiff_edge.h"
#include "optimize/rejection.h"
#include "system/planned_system.h"

namespace boxplus {
namespace {

/// Empties the report but keeps its memory.
void reset(Report& report) {
  std::vector<IterationRecord> records = std::move(report.records);
  std::vector<Report::EdgeJacobians> jacobians = std::move(report.jacobians);
  Report::GaugeReport gauge = std::move(report.gauge);
  std::vector<Id> cut_off = std::move(report.rejection.cut_off);
  std::string message = std::move(report.message);
  report = Report();
  records.clear();
  jacobians.clear();
  gauge.held.clear();
  gauge.free.clear();
  cut_off.clear();
  message.clear();
  report.rejection.cut_off = std::move(cut_off);
  report.records = std::move(records);
  report.jacobians = std::move(jacobians);
  report.gauge = std::move(gauge);
  report.message = std::move(message);
}

std::string vertex_text(const Graph& graph, VertexRef vertex) {
  return "vertex " + std::to_string(graph.id(vertex)) + " (" +
         std::string(graph.vertex_pools()[vertex.pool]->type_name()) + ")";
}

/// Appends the vertex or the edge that caused the run to end.
void add_culprit(std::string& message, Report::Reason reason, const Graph& graph, const RunSystem& system,
                 const Report& report) {
  if (reason == Report::Reason::kNotPositiveDefinite) {
    message += ": the Hessian is singular or indefinite at " + vertex_text(graph, system.failed_vertex()) +
               "; nothing measures it in some direction";
  } else if (reason == Report::Reason::kNotFinite) {
    message +=
        ": " + describe_non_finite(graph, system.plan(), system.linearize_options(), report.chi2_final);
  } else if (reason == Report::Reason::kRejectedEdges) {
    message += ": " + rejection_text(report.rejection);
  } else if (reason == Report::Reason::kConstraints) {
    const auto largest = [&](const Report::ConstraintResult& constraint) {
      return max_abs(graph.error(constraint.edge));
    };
    const auto worst = std::ranges::max_element(report.constraints, {}, largest);
    message += ": " + edge_text(graph, worst->edge) + " has an error of " + std::to_string(largest(*worst));
  } else if (reason == Report::Reason::kWeightSpan) {
    const auto stiff = find_stiff_edge(graph, system.plan(), system.linearize_options(), kStiffRatio);
    if (!stiff) return;
    message += ": in some direction, " + edge_text(graph, stiff->edge) +
               " has so large an Ω that other measurements of vertex " +
               std::to_string(graph.id(stiff->vertex)) + " are lost; lower its Ω, or fix what it measures";
  }
}

}  // namespace

void begin_report(Report& report, const Options& options) {
  // Reserves memory for this many records and characters, so that a later run does not allocate.
  constexpr int kRecords = 100;
  constexpr std::size_t kMessage = 100;
  reset(report);
  report.start.requested = options.start;
  report.threads = resolved_threads(options);
  report.chi2_initial = report.start.chi2_current = std::numeric_limits<double>::quiet_NaN();
  report.records.reserve(static_cast<std::size_t>(std::min(options.max_iterations, kRecords)));
  report.message.reserve(kMessage);
}

void describe_problem(Report& report, const Graph& graph, RunSystem& system, const Options& options,
                      EdgeCounter& counter) {
  const Plan& plan = system.plan();
  const RunSystem::Facts facts = system.facts();
  report.linear_solver = facts.solver;
  report.vertices = plan.structure.blocks();
  report.scalars = plan.free_scalars();
  report.eliminated = plan.eliminated_blocks;
  report.edges = plan.edge_count;
  const EdgeCounts counts = counter.count(graph, plan);
  report.rows = counts.rows;
  report.degrees_of_freedom =
      static_cast<std::int64_t>(counts.rows + counter.undetermined(graph, system)) - system.unknowns();
  report.disabled_edges = counts.disabled;
  report.robust_edges = counts.robust;
  report.linear = facts.statistics;
  report.workers = std::max(facts.workers, report.linear.workers);
  for (const detail::GaugeVertex& gauge : plan.held) report.gauge.held.push_back(gauge.id);
  report.gauge.free = plan.freedoms;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    report.jacobians.push_back({pool.type_name(), options.numeric_jacobians ? detail::JacobianSource::kNumeric
                                                                            : pool.jacobian_source()});
  }
}

void finish_report(Report& report, const Graph& graph, RunSystem& system, RunResult result) {
  const double chi2 = system.chi2();
  report.chi2_final = system.stopped() ? result.chi2 : chi2;  // if stopped, chi2() has no result
  if (report.robust_edges > 0 && !system.stopped())
    find_rejection(report.rejection, graph, system.plan(), system.facts().workers);
  if (result.status == Report::Status::kConverged && rejects_too_much(report.rejection)) {
    result.status = Report::Status::kNotConverged;
    result.reason = Report::Reason::kRejectedEdges;
  }
  report.status = result.status;
  report.reason = result.reason;
  report.linear = system.facts().statistics;
  report.gauge.held_directions = system.held_directions();
  if (!system.gauge_is_free()) report.gauge.free.clear();
  report.degrees_of_freedom += report.gauge.held_directions;
  for (const detail::GaugeFreedom& freedom : report.gauge.free)
    report.degrees_of_freedom += freedom.directions;
  report.message.assign(to_string(result.reason));
  add_culprit(report.message, result.reason, graph, system, report);
  if (std::isnan(report.chi2_initial) && is_interruption(result.reason))
    report.message += " before chi2 was evaluated";
}

// The estimates have not changed since the last iteration, if there was one, so chi2 has not changed either.
void finish_report_without_plan(Report& report, const Stopped& stopped) {
  report.status = Report::Status::kNotConverged;
  report.reason = stopped.by_flag() ? Report::Reason::kStopFlag : Report::Reason::kTimeLimit;
  report.chi2_final = report.records.empty() ? report.chi2_initial : report.records.back().chi2;
  report.message.assign(to_string(report.reason)) += " while planning";
  if (std::isnan(report.chi2_initial)) report.message += ", before chi2 was evaluated";
}

}  // namespace boxplus
