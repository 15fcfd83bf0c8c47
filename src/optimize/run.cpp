// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxplus {

Run::Run(Graph& graph, const Options& options, Report& report)
    : graph_(graph),
      options_(options),
      report_(report),
      stop_(options.stop, clock_.start(), options.time_limit_s) {
  constexpr int kRecords = 100;          // and
  constexpr std::size_t kMessage = 100;  // characters have room, so that a later run does not allocate
  report_.start.requested = options_.start;
  report_.threads = resolved_threads(options_);
  report_.chi2_initial = report_.start.chi2_current = std::numeric_limits<double>::quiet_NaN();
  report_.records.reserve(static_cast<std::size_t>(std::min(options_.max_iterations, kRecords)));
  report_.message.reserve(kMessage);
}

void Run::prepare() {
  {
    const TimeAdder adder(report_.time.plan_s);
    Session::Origin origin;
    session_ = &Session::find(graph_, options_, stop_, origin);
    report_.plan_reused = origin == Session::Origin::kReused;
    report_.plan_extended = origin == Session::Origin::kExtended;
    session_->set_in_use(true);
    in_use_.session = session_;
  }
  system().configure(options_, report_.time, stop_);
  describe_problem();
  session_->algorithm(options_).reset(options_, system().plan().scalars());
  report_.chi2_initial = report_.start.chi2_current = system().chi2();
}

void Run::describe_problem() {
  const Plan& plan = system().plan();
  report_.linear_solver = system().linear_solver().name();
  report_.algorithm = session_->algorithm(options_).name();
  report_.vertices = plan.structure.blocks();
  report_.scalars = plan.free_scalars();
  scalars_ = plan.free_scalars();
  report_.eliminated = plan.eliminated_blocks;
  report_.edges = plan.edge_count;
  report_.linear = system().linear_solver().statistics();
  report_.workers = std::max(system().linearizer().workers(), report_.linear.workers);
  report_.gauge.held.clear();
  for (const GaugeVertex& gauge : plan.held) report_.gauge.held.push_back(gauge.id);
  report_.gauge.free = plan.freedoms;
  report_.jacobians.clear();
  report_.disabled_edges = 0;
  for (const EdgeList& list : plan.edges) {
    const EdgePool& pool = *graph_.edge_pools()[list.pool];
    report_.jacobians.push_back(
        {pool.type_name(), options_.numeric_jacobians ? JacobianSource::kNumeric : pool.jacobian_source()});
    for (std::uint32_t edge : list.edges) {
      if (pool.enabled(edge)) {
        rows_ += pool.shape(edge).rows;
      } else {
        ++report_.disabled_edges;
      }
    }
  }
}

RunResult Run::minimize(double chi2) {
  return minimize_while([](const IterationRecord&) { return true; }, chi2);
}

RunResult Run::minimize_while(FunctionRef<bool(const IterationRecord&)> wanted, double chi2) {
  if (!std::isfinite(chi2)) return {Status::kFailed, Reason::kNotFinite, chi2, 0};
  Algorithm& algorithm = session_->algorithm(options_);
  algorithm.reset(options_, system().plan().scalars());
  const auto go_on = [&](const IterationRecord& record) { return call_back(record) && wanted(record); };
  const RunContext context{options_, iterations_left(), degrees_of_freedom(), stop_, clock_,
                           go_on,    report_.records};
  const RunResult result = boxplus::minimize(system(), algorithm, context, chi2);
  report_.iterations += result.iterations;
  report_.regularised_steps += algorithm.regularised_steps();
  return result;
}

bool Run::call_back(const IterationRecord& record) {
  if (!options_.callback) return true;
  const std::uint64_t revision = graph_.revision();
  const bool go_on = options_.callback(record);
  if (graph_.revision() != revision || graph_.cache().get() != session_) {
    throw InvalidArgument("Options::callback changed the structure of the graph, or optimised it");
  }
  return go_on;
}

}  // namespace boxplus
