// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/outliers.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "optimize/outliers/annealing.h"
#include "optimize/outliers/closure_search.h"
#include "optimize/outliers/doubts.h"

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

/// Optimizes without false loop closures. With `finish`, also makes the final run and the verdicts.
/// Otherwise, the verdicts only contain edges, and whether they are supported.
OutlierReport search(Graph& graph, const outliers::PoseGraph& poses, const OutlierOptions& options,
                     bool finish) {
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
  if (!finish) {
    for (std::size_t k = 0; k < poses.closures.size(); ++k) {
      result.verdicts.push_back(
          {.edge = poses.closures[k].edge, .supported = cycles.support[k] >= options.evidence});
    }
    return result;
  }
  result.report = search.finish();
  result.verdicts = search.verdicts();
  result.noise_scale = search.noise_scale();
  result.note = search.note();
  if (search.was_stopped()) {
    result.note = "the search was stopped, so no closure is judged";
    outliers::mark_as_stopped(result.report, options.options);
  } else {
    outliers::doubt_if_most_are_rejected(result);
  }
  return result;
}

/// Whether the map is probably right although edges were rejected: nearly all of the odometry fits, and so do
/// the loop closures that agree with their neighbors.
bool agrees_with_odometry(const outliers::Annealing& annealing, const outliers::PoseGraph& poses,
                          std::span<const EdgeRef> supported) {
  constexpr double kMostOdometry = 0.01, kMostSupported = 0.1;
  std::vector<EdgeRef> odometry;
  for (const outliers::PoseEdge& link : poses.links) odometry.push_back(link.edge);
  return !supported.empty() && annealing.rejected_share(odometry) <= kMostOdometry &&
         annealing.rejected_share(supported) <= kMostSupported;
}

OutlierReport judge_all(Graph& graph, const OutlierOptions& options) {
  outliers::Annealing annealing(graph, options);
  if (!annealing.has_edges()) {
    OutlierReport result;
    result.suspects = Suspects::kAll;
    result.report = optimize(graph, options.options);
    result.note = "the graph has no edges";
    return result;
  }
  const auto start_by = [&](Start start) {
    Options guess = options.options;
    guess.start = start;
    guess.max_iterations = 0;
    guess.callback = {};
    if (start != Start::kCurrent) static_cast<void>(optimize(graph, guess));
  };
  using enum outliers::Annealing::Begin;
  const outliers::PoseGraph poses(graph, options.options);
  std::vector<EdgeRef> supported;
  const auto from_odometry = [&] {
    if (poses.closures.empty()) return start_by(Start::kOdometry);
    supported.clear();
    for (const EdgeVerdict& closure : search(graph, poses, options, false).verdicts) {
      if (closure.supported) supported.push_back(closure.edge);
    }
  };
  const Start first = options.options.start == Start::kAutomatic ? Start::kCurrent : options.options.start;
  const auto from_first = [&] { start_by(first); };
  if (!poses.links.empty()) {
    annealing.minimize_from(from_odometry, kNear);
    if (!annealing.is_doubtful() || agrees_with_odometry(annealing, poses, supported))
      return annealing.finish();
    annealing.minimize_from(from_first, kNear);
    if (!annealing.is_doubtful()) return annealing.finish();
    annealing.minimize_from(from_odometry, kConvex);
  }
  annealing.minimize_from(from_first, kConvex);
  if (poses.links.empty() && annealing.is_doubtful()) annealing.minimize_from(from_first, kNear);
  if (annealing.is_noisy()) annealing.minimize_from(from_first, kTrustingOmega);
  return annealing.finish();
}

OutlierReport judge_closures(Graph& graph, const OutlierOptions& options) {
  const outliers::PoseGraph poses(graph, options.options);
  if (poses.is_mixed)
    throw InvalidArgument(
        "find_outliers: expected poses of one dimension, got poses in the plane and in space (with "
        "Suspects::kAll, they may be mixed)");
  if (poses.closures.empty()) {
    OutlierReport result;
    result.report = optimize(graph, options.options);
    result.note = "the graph has no loop closures";
    return result;
  }
  if (poses.links.empty())
    throw InvalidArgument(
        "find_outliers: expected odometry (edges between poses with consecutive ids), got none");
  return search(graph, poses, options, true);
}

}  // namespace

std::string_view detail::to_string(Verdict verdict) {
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

OutlierReport find_outliers(Graph& graph, const OutlierOptions& given) {
  check(given);
  OutlierOptions options = given;
  options.options.outliers.reset();
  return options.suspects == Suspects::kAll ? judge_all(graph, options) : judge_closures(graph, options);
}

}  // namespace boxplus
