// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/thread_comparison.h"

#include <stdexcept>

#include "boxplus/optimize/optimizer.h"
#include "datasets/interleave.h"

namespace boxplus::bench {
namespace {

Figures run(Graph& graph, int threads) {
  graph.push();
  const Report report = optimize(graph, {.start = Start::kAutomatic, .threads = threads});
  graph.pop();
  return {report.time.total_s, report.chi2_final};
}

}  // namespace

ThreadComparison run_thread_comparison(Graph& graph) {
  const std::vector<Figures> medians =
      interleaved_medians({[&] { return run(graph, 1); }, [&] { return run(graph, 2); }},
                          {.least = 11, .most = 15, .enough_s = 3});
  if (medians[0][1] != medians[1][1])
    throw std::runtime_error("one thread and two threads end at different chi2");
  return {medians[0][0], medians[1][0]};
}

}  // namespace boxplus::bench
