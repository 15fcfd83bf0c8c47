// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/descent.h"

#include <cmath>

namespace boxplus {
namespace {

double count_degrees_of_freedom(const Graph& graph, const Plan& plan) {
  double rows = 0;
  for (const EdgeList& list : plan.edges) {
    const EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (pool.enabled(edge)) rows += pool.shape(edge).rows;
    }
  }
  return rows - plan.free_scalars();
}

}  // namespace

Descent::Descent(Graph& graph, BatchSystem& system, Algorithm& algorithm, const Options& options,
                 const StopToken& stop, const Stopwatch& clock, std::vector<IterationRecord>& records)
    : graph_(graph),
      system_(system),
      algorithm_(algorithm),
      options_(options),
      stop_(stop),
      clock_(clock),
      records_(records),
      degrees_of_freedom_(count_degrees_of_freedom(graph, system.plan())) {}

RunResult Descent::run(double chi2) {
  return run_while([](const IterationRecord&) { return true; }, chi2);
}

RunResult Descent::run_while(FunctionRef<bool(const IterationRecord&)> wanted, double chi2) {
  if (!std::isfinite(chi2)) return {Status::kFailed, Reason::kNotFinite, chi2, 0};
  algorithm_.reset(options_, system_.plan().scalars());
  const auto go_on = [&](const IterationRecord& record) { return call_back(record) && wanted(record); };
  const RunContext context{options_, iterations_left(), degrees_of_freedom_, stop_, clock_, go_on, records_};
  const RunResult result = minimize(system_, algorithm_, context, chi2);
  iterations_ += result.iterations;
  regularized_steps_ += algorithm_.regularized_steps();
  return result;
}

bool Descent::call_back(const IterationRecord& record) {
  if (!options_.callback) return true;
  const std::uint64_t revision = graph_.revision();
  const std::shared_ptr<detail::LifeState> life = graph_.life();
  const bool go_on = options_.callback(record);
  if (life->is_over || graph_.revision() != revision)
    throw InvalidArgument("Options::callback changed the structure of the graph");
  return go_on;
}

}  // namespace boxplus
