// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/closure_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "boxplus/base/progress.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/default_width.h"
#include "outliers/gaps.h"
#include "outliers/path_tree.h"

namespace boxplus::outliers {
namespace {

/// The factor of a limit above which an accepted closure is ejected, and a rejected one is an outlier.
constexpr double kFarAbove = 4;
/// The factor of a limit below which a closure without support is accepted.
constexpr double kWellBelow = 0.25;
/// How much more evidence a closure without support needs: it must be right although it is alone.
constexpr double kMoreEvidence = 4;
/// A closure that was ejected this often is not accepted again before the end.
constexpr int kMostEjections = 2;
/// The number of trees in which paths between poses are searched. More trees find shorter paths.
constexpr std::uint32_t kFewTrees = 3, kManyTrees = 10;

}  // namespace

ClosureSearch::ClosureSearch(Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                             const CycleTests& cycles, const Evidence& evidence,
                             const OutlierOptions& options)
    : graph_(graph),
      poses_(poses),
      chain_(chain),
      cycles_(cycles),
      evidence_(evidence),
      options_(options),
      accepted_(poses.closures.size(), 0),
      is_bridge_(accepted_),
      ejections_(poses.closures.size(), 0),
      chi2_(poses.closures.size(), 0) {
  std::vector<double> quantile_of, median_of;
  for (const PoseEdge& closure : poses.closures) {
    const auto rows = static_cast<std::size_t>(closure.rows);
    if (rows >= quantile_of.size()) {
      quantile_of.resize(rows + 1, 0);
      median_of.resize(rows + 1, 0);
    }
    if (quantile_of[rows] == 0) {
      quantile_of[rows] = chi2_quantile(closure.rows, 1 - options.false_alarm);
      median_of[rows] = chi2_quantile(closure.rows, 0.5);
    }
    quantile_.push_back(quantile_of[rows]);
    median_.push_back(median_of[rows]);
  }
}

// ---- Runs ----

std::size_t ClosureSearch::accepted_count() const {
  return static_cast<std::size_t>(std::count(accepted_.begin(), accepted_.end(), 1));
}

std::vector<const PoseEdge*> ClosureSearch::accepted_edges() const {
  std::vector<const PoseEdge*> edges;
  for (const PoseEdge& link : poses_.links) edges.push_back(&link);
  for (std::size_t k = 0; k < poses_.closures.size(); ++k) {
    if (accepted_[k]) edges.push_back(&poses_.closures[k]);
  }
  return edges;
}

Report ClosureSearch::optimize_accepted(Options options) {
  options.edges = poses_.others;
  for (const PoseEdge* edge : accepted_edges()) options.edges.push_back(edge->edge);
  Report report = optimize(graph_, options);
  measure();
  return report;
}

void ClosureSearch::optimize_briefly(int iterations, Start start) {
  Options options = options_.options;
  options.start = start;
  options.max_iterations = iterations;
  options.callback = {};
  static_cast<void>(optimize_accepted(options));
}

/// Evaluates the closures, and derives the limits from the fit of the accepted ones.
void ClosureSearch::measure() {
  for (std::size_t k = 0; k < chi2_.size(); ++k) chi2_[k] = graph_.chi2(poses_.closures[k].edge);
  // If the noise is far below Ω, a limit in proportion to Ω accepts closures that disagree with all others.
  constexpr double kMargin = 25;
  noise_scale_ = noise_scale();
  limit_scale_ = std::max(noise_scale_, std::min(1.0, kMargin * noise_scale_));
}

double ClosureSearch::noise_scale() const {
  constexpr std::size_t kEnough = 10;
  std::vector<double> ratios;
  for (std::size_t k = 0; k < chi2_.size(); ++k) {
    if (accepted_[k] && std::isfinite(chi2_[k])) ratios.push_back(chi2_[k] / median_[k]);
  }
  if (ratios.size() < kEnough) return cycles_.noise_scale;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return std::max(cycles_.noise_scale, *middle);
}

Report ClosureSearch::finish() {
  if (all_accepted_ && !options_.options.callback) return *all_accepted_;
  Options options = options_.options;
  options.start = Start::kCurrent;
  return optimize_accepted(options);
}

bool ClosureSearch::may_accept_all() const {
  constexpr double kMostUnsupported = 0.02, kMostContradictory = 0.002, kTolerance = 16, kFew = 0.05;
  std::size_t unsupported = 0, contradictory = 0;
  for (std::size_t k = 0; k < poses_.closures.size(); ++k) {
    const PoseEdge& closure = poses_.closures[k];
    unsupported += !is_supported(k);
    if (chain_.part(closure.from) != chain_.part(closure.to)) continue;
    const Motion &from = chain_.pose(closure.from), &to = chain_.pose(closure.to);
    const Spread path = chain_.between(closure.from, closure.to).spread_at(to.translation);
    const auto deviation = Deviation::between(from.inverse_times(to), closure.motion, path + closure.spread);
    contradictory += evidence_.log_odds(deviation, kTolerance * cycles_.noise_scale) < -options_.evidence;
  }
  const auto count = static_cast<double>(poses_.closures.size());
  if (count <= kFew * static_cast<double>(poses_.poses.size())) return true;  // a run with them is cheap
  return static_cast<double>(unsupported) <= kMostUnsupported * count &&
         static_cast<double>(contradictory) <= kMostContradictory * count;
}

/// The number of rows of all accepted edges, minus the number of unknowns. Gauge freedom is neglected.
double ClosureSearch::degrees_of_freedom() const {
  double degrees = 0;
  for (const PoseEdge* edge : accepted_edges()) degrees += edge->rows;
  for (const EdgeRef& edge : poses_.others) degrees += graph_.edge_pools()[edge.pool]->shape(edge.slot).rows;
  for (const auto& pool : graph_.vertex_pools()) {
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (!pool->alive(slot) || pool->fixed(slot) || pool->parameter(slot)) continue;
      degrees -= pool->tangent_dim(slot) - static_cast<int>(pool->fixed_directions(slot).size());
    }
  }
  return std::max(1.0, degrees);
}

bool ClosureSearch::accept_all() {
  std::fill(accepted_.begin(), accepted_.end(), 1);
  Options options = options_.options;
  options.start = Start::kAutomatic;
  // False closures may also bend the odometry until they fit.
  constexpr double kMostChi2 = 4;
  const double most = std::max(1.0, kMostChi2 * cycles_.noise_scale);
  // With false closures, chi2 falls slowly above its limit, and each iteration is expensive, because they
  // fill the factor. So the run is given up if a few more iterations like the last one would not suffice.
  constexpr int kFewIterations = 2, kMoreIterations = 4;
  const double degrees = degrees_of_freedom();
  double before = std::numeric_limits<double>::infinity();
  options.callback = [&](const IterationRecord& record) {
    const double ahead = record.chi2 * std::pow(record.chi2 / before, kMoreIterations);
    before = record.chi2;
    return record.iteration <= kFewIterations || !(ahead > most * degrees);
  };
  const Report report = optimize_accepted(options);
  bool all_fit = report.converged() && !(report.chi2_per_degree() > most);
  // A single false closure bends the map until its own error is small. So a closure without support has no
  // margin, unless the noise of closures differs so much from that of cycles that their Ω cannot be compared.
  constexpr double kSimilar = 4;
  const double scale = noise_scale();
  const bool is_strict = scale <= kSimilar * cycles_.noise_scale;
  for (std::size_t k = 0; k < chi2_.size(); ++k) {
    const double most_of_closure =
        is_strict && !is_supported(k) ? quantile_[k] * scale : kFarAbove * limit(k);
    all_fit = all_fit && chi2_[k] <= most_of_closure;
  }
  if (!all_fit) std::fill(accepted_.begin(), accepted_.end(), 0);
  if (all_fit) all_accepted_ = report;
  return all_fit;
}

// ---- Stages ----

void ClosureSearch::bridge_gaps() {
  const Bridges bridges = outliers::bridge_gaps(graph_, poses_, chain_, cycles_, options_.evidence);
  for (const std::uint32_t closure : bridges.supported) accepted_[closure] = 1;
  for (const std::uint32_t closure : bridges.unsupported) accepted_[closure] = is_bridge_[closure] = 1;
  const std::size_t count = bridges.unsupported.size();
  if (count == 0) return;
  note_ = fmt::format(
      "{} gap{} in the odometry {} bridged by loop closures that no other closure confirms; they cannot be "
      "judged",
      count, count == 1 ? "" : "s", count == 1 ? "is" : "are");
}

void ClosureSearch::accept_in_stages() {
  constexpr int kMostStages = 200, kOdometryIterations = 10, kIterations = 3, kMostInflations = 4;
  constexpr double kFew = 0.02;  // not enough for a run of its own
  bridge_gaps();
  optimize_briefly(kOdometryIterations, Start::kOdometry);
  for (int stage = 0; stage < kMostStages && !was_stopped(); ++stage) {
    const std::vector<Deviation> found = deviations(kFewTrees);
    // If the odometry is worse than its Ω says, only a larger scale explains true closures.
    std::size_t added = 0;
    const double scale = noise_scale(), few = kFew * static_cast<double>(accepted_count());
    for (int inflation = 0; static_cast<double>(added) <= few && inflation <= kMostInflations; ++inflation)
      added += add_certain(found, scale * std::exp2(2 * inflation));
    const bool is_certain = added > 0;
    if (!is_certain && !add_on_trial(deviations(kManyTrees))) return;
    note_progress();
    optimize_briefly(kIterations);
    eject(is_certain ? 1 : kMostEjections);
  }
}

void ClosureSearch::note_progress() const {
  if (!detail::is_watched()) return;
  detail::note_progress(std::numeric_limits<double>::quiet_NaN(),
                        fmt::format("{} of {} loop closures accepted", accepted_count(), accepted_.size()));
}

bool ClosureSearch::may_add(std::size_t closure) const {
  return !accepted_[closure] && ejections_[closure] < kMostEjections;
}

/// If closures agree with each other, either all of them are false or none is. False groups are small, so a
/// large group needs less evidence.
double ClosureSearch::group_bonus(std::size_t closure) const {
  constexpr double kLargestFalseGroup = 10, kMost = 6;
  if (!is_supported(closure)) return -kMoreEvidence;
  return std::clamp((cycles_.group_size[closure] - kLargestFalseGroup) / kLargestFalseGroup, 0.0, kMost);
}

/// Accepts the closures with enough evidence, and returns their number.
std::size_t ClosureSearch::add_certain(std::span<const Deviation> deviations, double scale) {
  std::size_t added = 0;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    if (!may_add(k) || evidence_.log_odds(deviations[k], scale) + group_bonus(k) < options_.evidence)
      continue;
    accepted_[k] = 1;
    ++added;
  }
  return added;
}

/// Accepts the group with the most evidence on trial or, if no group has enough evidence, single closures
/// without support. Returns whether there were any.
bool ClosureSearch::add_on_trial(std::span<const Deviation> deviations) {
  const Needed needed = needed_on_trial();
  const double scale = noise_scale();
  double most = needed.by_group;
  std::optional<std::uint32_t> best;
  std::vector<double> odds(deviations.size(), 0);
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    if (!may_add(k)) continue;
    odds[k] = evidence_.log_odds(deviations[k], scale);
    if (!is_supported(k) || odds[k] + group_bonus(k) <= most) continue;
    most = odds[k] + group_bonus(k);
    best = cycles_.group[k];
  }
  bool added = false;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const bool wanted =
        best ? cycles_.group[k] == *best && odds[k] > 0 : !is_supported(k) && odds[k] > needed.by_lone;
    if (!wanted || !may_add(k)) continue;
    accepted_[k] = 1;
    added = true;
  }
  return added;
}

/// The evidence with which a group or a closure without support is more likely true than false. Of n false
/// ones, n e^−x have at least x nats of evidence by chance.
ClosureSearch::Needed ClosureSearch::needed_on_trial() const {
  constexpr double kAtLeast = 3, kMargin = 1;
  std::set<std::uint32_t> groups;
  std::set<std::pair<std::uint32_t, std::uint32_t>> lone;  // copies count once
  for (std::size_t k = 0; k < accepted_.size(); ++k) {
    if (accepted_[k]) continue;
    const PoseEdge& closure = poses_.closures[k];
    is_supported(k) ? void(groups.insert(cycles_.group[k])) : void(lone.emplace(closure.from, closure.to));
  }
  const auto needed = [&](std::size_t count) {
    return std::max(kAtLeast, std::log(static_cast<double>(std::max<std::size_t>(1, count))) + kMargin);
  };
  return {needed(groups.size()), needed(lone.size())};
}

void ClosureSearch::eject(int penalty) {
  for (std::size_t k = 0; k < chi2_.size(); ++k) {
    if (!accepted_[k] || is_bridge_[k] || chi2_[k] <= kFarAbove * limit(k)) continue;
    accepted_[k] = 0;
    ejections_[k] += penalty;
  }
}

/// The deviation of each closure that is not accepted from the current estimates, with the uncertainty of the
/// shortest known path between its poses.
std::vector<Deviation> ClosureSearch::deviations(std::uint32_t trees) const {
  const std::vector<Motion> estimates = poses_.estimates(graph_);
  const std::vector<const PoseEdge*> edges = accepted_edges();
  if (accepted_count() == accepted_.size()) trees = 0;  // nothing to compare
  const Neighbors neighbors(estimates.size(), edges);
  std::vector<PathTree> paths;
  const auto count = static_cast<std::uint32_t>(estimates.size());
  for (std::uint32_t k = 0; k < trees; ++k) {
    const auto root = static_cast<std::uint32_t>(std::uint64_t{2 * k + 1} * count / (2 * trees));
    paths.emplace_back(neighbors, estimates, root, evidence_.extent() / 4);
  }
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const double scale = noise_scale();
  std::vector<Deviation> result(chi2_.size(), {0, 0, {kUnknown, kUnknown}});
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (accepted_[k]) continue;
    const PoseEdge& closure = poses_.closures[k];
    Spread path{kUnknown, kUnknown};
    double most = evidence_.most(path, scale);
    const auto take_if_shorter = [&](const Spread& spread) {
      const double evidence = evidence_.most(spread + closure.spread, scale);
      if (evidence > most) most = evidence, path = spread;
    };
    if (chain_.part(closure.from) == chain_.part(closure.to))
      take_if_shorter(
          chain_.between(closure.from, closure.to).spread_at(chain_.pose(closure.to).translation));
    for (const PathTree& tree : paths) {
      if (const auto spread = tree.between(closure.from, closure.to)) take_if_shorter(*spread);
    }
    const Motion expected = estimates[closure.from].inverse_times(estimates[closure.to]);
    result[k] = Deviation::between(expected, closure.motion, path + closure.spread);
  }
  return result;
}

// ---- The end ----

void ClosureSearch::settle() {
  constexpr int kMostPasses = 10, kMostAdditions = 5, kIterations = 10;
  for (int pass = 0; pass < kMostPasses && !was_stopped(); ++pass) {
    optimize_briefly(kIterations);
    if (!reconsider(pass < kMostAdditions)) return;
  }
}

/// The limit below which a closure is part of the result. A single false closure bends the map until its own
/// error is small, and a few of thousands agree by chance. So the margin for noise that is far below Ω grows
/// with the number of closures that support it.
double ClosureSearch::limit_of_result(std::size_t closure) const {
  const double margin = 1.0 + 2.0 * cycles_.supporters[closure];
  const double share = accepted_[closure] || is_supported(closure) ? 1 : kWellBelow;
  return share * quantile_[closure] * std::min(limit_scale_, margin * noise_scale_);
}

/// Accepts the closures below their limits, and rejects the others. Returns whether anything changed.
bool ClosureSearch::reconsider(bool may_add) {
  bool changed = false;
  for (std::size_t k = 0; k < chi2_.size(); ++k) {
    const bool fits = is_bridge_[k] || chi2_[k] <= limit_of_result(k);
    if (fits == static_cast<bool>(accepted_[k]) || (fits && !may_add)) continue;
    accepted_[k] = fits ? 1 : 0;
    changed = true;
  }
  return changed;
}

std::vector<EdgeVerdict> ClosureSearch::verdicts() {
  /// With this much less evidence than needed, a closure is more likely false than true.
  constexpr double kFarBelow = 2;
  const std::vector<Deviation> found = deviations(kManyTrees);
  const double scale = noise_scale();
  const Needed needed = needed_on_trial();
  const auto bonus = [&](std::size_t k) { return is_supported(k) ? group_bonus(k) : 0; };
  const auto is_testable = [&](std::size_t k) {
    return accepted_[k] || evidence_.most(found[k].spread, scale) + bonus(k) >= options_.evidence;
  };
  std::size_t untestable = 0;
  for (std::size_t k = 0; k < found.size(); ++k) untestable += !is_testable(k);
  // If the estimates rest on fewer closures than cannot be tested, they are not good enough to condemn any.
  const bool is_vague = untestable > accepted_count();
  if (leaves_parts_apart(graph_, poses_, chain_, accepted_)) {
    note_ =
        "no accepted closure bridges some of the gaps in the odometry, so parts of the map are not connected";
  } else if (is_vague && note_.empty()) {
    note_ =
        fmt::format("{} loop closures are undecided, because the paths between their poses are too uncertain",
                    untestable);
  }
  std::vector<EdgeVerdict> result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double odds = evidence_.log_odds(found[k], scale) + bonus(k);
    const bool is_unlikely = odds < (is_supported(k) ? needed.by_group : needed.by_lone) - kFarBelow &&
                             chi2_[k] > kFarAbove * limit(k) && (is_testable(k) || !is_vague);
    const PoseEdge& closure = poses_.closures[k];
    EdgeVerdict verdict{.edge = closure.edge,
                        .from = graph_.id(poses_.poses[closure.from]),
                        .to = graph_.id(poses_.poses[closure.to]),
                        .weight = static_cast<double>(accepted_[k]),
                        .chi2 = chi2_[k],
                        .supported = is_supported(k)};
    if (!was_stopped() && accepted_[k] && !is_bridge_[k]) verdict.verdict = Verdict::kInlier;
    if (!was_stopped() && !accepted_[k] && is_unlikely) verdict.verdict = Verdict::kOutlier;
    result.push_back(verdict);
  }
  return result;
}

}  // namespace boxplus::outliers
