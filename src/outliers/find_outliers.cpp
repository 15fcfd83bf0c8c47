// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/stopwatch.h"
#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/outliers/outliers.h"
#include "graph/snapshot.h"
#include "outliers/annealing.h"
#include "outliers/closure_search.h"
#include "outliers/doubts.h"
#include "outliers/false_odometry.h"

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

/// A search for false loop closures, with all that it is based on.
class Search {
 public:
  Search(Graph& graph, outliers::PoseGraph poses, const OutlierOptions& options)
      : poses_(std::move(poses)),
        chain_(poses_),
        evidence_(poses_, along(chain_, poses_)),
        cycles_(test_cycles(poses_, chain_, evidence_, options.evidence, options.window)),
        closures_(graph, poses_, chain_, cycles_, evidence_, options) {}

  void run() {
    if (closures_.may_accept_all() && closures_.accept_all()) return;
    closures_.accept_in_stages();
    closures_.settle();
  }

  /// The poses whose links between the same two of them are suspects if they contradict each other.
  static outliers::PoseGraph suspecting_contradictions(outliers::PoseGraph poses,
                                                       const OutlierOptions& options) {
    const outliers::OdometryChain chain(poses);
    const outliers::Evidence evidence(poses, along(chain, poses));
    const double scale = test_cycles(poses, chain, evidence, options.evidence, options.window).noise_scale;
    const auto suspects = contradicting_links(poses, evidence, scale, options.evidence);
    poses.suspect([&](std::size_t link) { return suspects[link] != 0; });
    return poses;
  }

  const outliers::PoseGraph& poses() const { return poses_; }
  outliers::ClosureSearch& closures() { return closures_; }
  bool is_supported(std::size_t closure, double evidence) const {
    return cycles_.support[closure] >= evidence;
  }
  /// The number of accepted closures between poses that are no neighbors.
  std::size_t accepted() {
    const std::vector<EdgeVerdict>& verdicts = verdicts_after_run();
    std::size_t count = 0;
    for (std::size_t k = 0; k < verdicts.size(); ++k)
      count += verdicts[k].weight > 0 && poses_.closures[k].to - poses_.closures[k].from > 1;
    return count;
  }
  std::optional<outliers::Contradiction> contradiction(const Graph& graph) {
    return most_contradicted_link(graph, poses_, cycles_, verdicts_after_run());
  }
  std::size_t rejected_in_large_groups() {
    return outliers::rejected_in_large_groups(cycles_, verdicts_after_run());
  }

 private:
  /// The verdicts at the estimates to which run() led.
  const std::vector<EdgeVerdict>& verdicts_after_run() {
    if (verdicts_.empty()) verdicts_ = closures_.verdicts();
    return verdicts_;
  }
  static std::vector<outliers::Motion> along(const outliers::OdometryChain& chain,
                                             const outliers::PoseGraph& poses) {
    std::vector<outliers::Motion> result;
    for (std::uint32_t k = 0; k < poses.poses.size(); ++k) result.push_back(chain.pose(k));
    return result;
  }

  const outliers::PoseGraph poses_;
  const outliers::OdometryChain chain_;
  const outliers::Evidence evidence_;
  const outliers::CycleTests cycles_;
  outliers::ClosureSearch closures_;
  std::vector<EdgeVerdict> verdicts_;
};

/// Suspects the links that many closures contradict, and those that accepted closures bend. If more closures
/// fit without a link, it remains a suspect of `search`. Returns a contradiction that remains.
std::optional<outliers::Contradiction> suspect_odometry(Graph& graph, const OutlierOptions& options,
                                                        std::unique_ptr<Search>& search) {
  constexpr int kMostRuns = 20;

  int runs = 0;
  std::set<std::uint32_t> tried;
  const auto fits_better_without = [&](std::uint32_t to) {
    if (!tried.insert(to).second || ++runs > kMostRuns || search->closures().was_stopped()) return false;
    outliers::PoseGraph poses = search->poses();
    poses.suspect([&](std::size_t k) { return search->poses().links[k].to == to; });
    outliers::Snapshot before;
    before.take(graph);
    auto other = std::make_unique<Search>(graph, std::move(poses), options);
    other->run();
    const bool is_better = other->accepted() > search->accepted();
    is_better ? void(search = std::move(other)) : before.put_back(graph);
    return is_better;
  };
  while (true) {
    const auto contradiction = search->contradiction(graph);
    if (contradiction && fits_better_without(contradiction->to)) continue;
    const auto bent = bent_links(graph, search->poses(), search->closures().noise_scale());
    if (std::ranges::any_of(bent, fits_better_without)) continue;
    return contradiction;
  }
}

/// Optimizes without false loop closures. With `finish`, also makes the final run and the verdicts.
/// Otherwise, the verdicts only contain edges, and whether they are supported.
OutlierReport find_false_closures(Graph& graph, const outliers::PoseGraph& poses,
                                  const OutlierOptions& options, bool finish) {
  auto search = std::make_unique<Search>(graph, Search::suspecting_contradictions(poses, options), options);
  search->run();
  OutlierReport result;
  if (!finish) {
    for (std::size_t k = 0; k < search->poses().closures.size(); ++k) {
      result.verdicts.push_back(
          {.edge = search->poses().closures[k].edge, .supported = search->is_supported(k, options.evidence)});
    }
    return result;
  }
  const auto contradiction = suspect_odometry(graph, options, search);
  outliers::ClosureSearch& closures = search->closures();
  result.report = closures.finish();
  result.verdicts = closures.verdicts();
  result.noise_scale = closures.noise_scale();
  result.note = closures.note();
  if (closures.was_stopped()) {
    result.note = "the search was stopped, so no closure is judged";
    outliers::mark_as_stopped(result.report, options.options);
  } else if (contradiction) {
    const std::vector<VertexRef>& all = search->poses().poses;
    outliers::doubt(result, fmt::format("{} rejected loop closures agree with each other, but not with the "
                                        "odometry between {} and {}",
                                        contradiction->closures, graph.id(all[contradiction->to - 1]),
                                        graph.id(all[contradiction->to])));
  } else if (const std::size_t rejected = search->rejected_in_large_groups()) {
    outliers::doubt(
        result, fmt::format("{} rejected loop closures agree with each other, so the odometry may be wrong",
                            rejected));
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
    for (const EdgeVerdict& closure : find_false_closures(graph, poses, options, false).verdicts) {
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
  return find_false_closures(graph, poses, options, true);
}

}  // namespace

OutlierReport find_outliers(Graph& graph, const OutlierOptions& options) {
  check(options);
  const Stopwatch clock;
  OutlierReport result =
      options.suspects == Suspects::kAll ? judge_all(graph, options) : judge_closures(graph, options);
  result.time_s = clock.seconds();
  return result;
}

}  // namespace boxplus
