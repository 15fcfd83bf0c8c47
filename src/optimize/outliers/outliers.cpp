// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/outliers.h"

#include <fmt/format.h>

#include <algorithm>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "optimize/outliers/closure_search.h"

namespace boxplus {
namespace {

void check(const OutlierOptions& options) {
  if (!(options.false_alarm > 1e-9 && options.false_alarm < 1))
    throw InvalidArgument(fmt::format(
        "OutlierOptions::false_alarm: expected a probability > 1e-9 and < 1, got {}", options.false_alarm));
  if (!(options.evidence > 0))
    throw InvalidArgument(
        fmt::format("OutlierOptions::evidence: expected a positive number, got {}", options.evidence));
  if (options.window < 1)
    throw InvalidArgument(fmt::format("OutlierOptions::window: expected at least 1, got {}", options.window));
  if (!options.options.vertices.empty())
    throw InvalidArgument(fmt::format("OutlierOptions::options: expected no `vertices`, got {}",
                                      options.options.vertices.size()));
}

OutlierReport search(Graph& graph, const outliers::PoseGraph& poses, const OutlierOptions& options) {
  const outliers::OdometryChain chain(poses);
  std::vector<outliers::Motion> along_odometry;
  for (std::uint32_t k = 0; k < poses.poses.size(); ++k) along_odometry.push_back(chain.pose(k));
  const outliers::Evidence evidence(poses, along_odometry);
  const outliers::CycleTests cycles = test_cycles(poses, chain, evidence, options.evidence, options.window);
  outliers::ClosureSearch search(graph, poses, chain, cycles, evidence, options);
  if (!search.may_accept_all() || !search.accept_all()) {
    search.accept_in_stages();
    search.settle();
  }
  OutlierReport result;
  result.report = search.finish();
  result.verdicts = search.verdicts();
  result.noise_scale = search.noise_scale();
  result.note = search.was_stopped() ? "the search was stopped, so no closure is judged" : search.note();
  return result;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kInlier:
      return "inlier";
    case Verdict::kOutlier:
      return "outlier";
    default:
      return "undecided";
  }
}

std::size_t OutlierReport::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::count_if(
      verdicts.begin(), verdicts.end(), [&](const EdgeVerdict& edge) { return edge.verdict == verdict; }));
}

std::vector<EdgeRef> OutlierReport::edges(Verdict verdict) const {
  std::vector<EdgeRef> result;
  for (const EdgeVerdict& edge : verdicts) {
    if (edge.verdict == verdict) result.push_back(edge.edge);
  }
  return result;
}

OutlierReport find_outliers(Graph& graph, const OutlierOptions& options) {
  check(options);
  const outliers::PoseGraph poses(graph, options.options);
  if (poses.closures.empty()) {
    OutlierReport result;
    result.report = optimize(graph, options.options);
    result.note = "the graph has no loop closures";
    return result;
  }
  if (poses.links.empty())
    throw InvalidArgument(
        "find_outliers: expected odometry (edges between poses with consecutive ids), got none");
  return search(graph, poses, options);
}

}  // namespace boxplus
