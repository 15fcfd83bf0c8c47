// SPDX-License-Identifier: BSD-3-Clause
// Finds false loop closures in pose graphs, with a verdict for each closure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/optimize/report.h"

namespace boxplus {

enum class Verdict : std::uint8_t {
  kInlier,    ///< the closure agrees with the map; it takes part in the final run
  kOutlier,   ///< the closure is false
  kUndecided  ///< not enough evidence; it takes no part in the final run, unless it bridges a gap
};
std::string_view to_string(Verdict verdict);

struct OutlierOptions {
  /// The options of all runs. `level` and `edges` choose the edges to use and to judge. `start` and
  /// `max_iterations` have no effect on the search: it starts from the odometry, and only the final run
  /// counts iterations. `callback` is called by the final run. `time_limit_s` limits each run, and `stop`
  /// ends the search. `vertices` must be empty.
  Options options = {};
  /// The probability that the chi2 of a true closure with Gaussian noise exceeds the limit above which a
  /// closure is rejected. In (1e-9, 1).
  double false_alarm = 2e-4;
  /// The evidence for a closure, as the natural logarithm of an odds ratio, above which it counts as certain.
  /// The odds compare "true" with "anywhere on the map". Positive.
  double evidence = 9;
  /// Two closures can support each other if neither their first nor their second poses are further apart
  /// than this, in poses along the odometry. At least 1.
  int window = 40;
};

/// The verdict on one closure.
struct EdgeVerdict {
  EdgeRef edge;
  Id from = 0, to = 0;  ///< the ids of its two poses; `from` is the lower one
  Verdict verdict = Verdict::kUndecided;
  double weight = 0;  ///< the factor of its Ω in the final run: 1 if it takes part, otherwise 0
  double chi2 = 0;    ///< eᵀΩe at the final estimates
  /// Whether it agrees with a neighboring closure: the cycle through both closures and the odometry between
  /// their ends closes, to within the uncertainty.
  bool supported = false;
};

struct [[nodiscard]] OutlierReport {
  Report report;                      ///< of the final run, in which only the accepted edges take part
  std::vector<EdgeVerdict> verdicts;  ///< one for each closure, in the order of Graph::all_edges()
  /// The factor of the noise variances that explains the accepted closures. If it is 1, all Ω fit the errors.
  double noise_scale = 1;
  /// One sentence about a limitation of the result, or empty.
  std::string note;

  std::size_t count(Verdict verdict) const;
  /// The closures with this verdict.
  std::vector<EdgeRef> edges(Verdict verdict) const;
};

/// Optimizes a pose graph without its false loop closures.
///
/// A closure is an edge that measures the full motion between two poses that are not neighbors in the order
/// of ids, and whose Ω is regular. All other edges are trusted: odometry, observations of landmarks, priors.
/// Half of the closures may be false, and false closures may agree with each other in small groups. The
/// method:
///
///   1. The estimates follow the odometry, which false closures cannot distort.
///   2. Closures between neighboring poses are tested in pairs. If two of them close a cycle, both are
///      supported (Latif, Cadena & Neira, "Robust loop closing over time for pose graph SLAM", IJRR 2013,
///      and Mangelson et al., "Pairwise consistent measurement set maximization", ICRA 2018, test such
///      cycles). All pairs together determine the scale of the noise, so that Ω need only be right up to a
///      common factor.
///   3. Supported closures are accepted in stages: first those whose error is small and could not be small by
///      chance, given the uncertainty of the path between their poses. After each stage, the accepted edges
///      are optimized, and closures with large errors are ejected again.
///   4. At the end, every closure is compared with the estimates: it is an inlier if its chi2 is below the
///      limit of OutlierOptions::false_alarm. A closure without support needs half of that error.
///
/// If a gap in the odometry divides the poses into parts, supported closures connect these parts. If there
/// are none, the gap is bridged by closures that cannot be judged: they are kept with Verdict::kUndecided and
/// weight 1, and `note` says so.
///
/// Edges keep their kernels and enabled flags; no edge is removed. Disabled edges are ignored. Throws
/// InvalidArgument if `options` are out of their ranges, and if the graph has closures but no odometry.
///
/// If most paths between poses are too uncertain to test closures, no closure is an outlier only because its
/// error is large, and `note` says so. If Options::stop ends the search, all verdicts are kUndecided.
///
/// If all closures may be true, the function first optimizes with all of them, and ends if they fit: this
/// takes about as long as one to three runs of optimize(). Otherwise, it takes about as long as 2 to 15 runs
/// without the false closures, and up to 25 on small or very noisy graphs.
///
/// `report` is about the accepted edges only: it may say "converged" although closures are undecided and the
/// map is wrong. `note` then says so.
OutlierReport find_outliers(Graph& graph, const OutlierOptions& options = {});

}  // namespace boxplus
