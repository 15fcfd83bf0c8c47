// SPDX-License-Identifier: BSD-3-Clause
// Finds false measurements: loop closures of pose graphs, or edges of any kind, with a verdict for each.
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
  kInlier,   ///< the edge agrees with the estimates; it takes part in the final run
  kOutlier,  ///< the edge is false
  /// Not enough evidence. A loop closure takes no part in the final run, unless it bridges a gap. If all
  /// edges are suspects, an edge takes part if it fits; this happens if nothing else measures its vertex.
  kUndecided
};
std::string_view to_string(Verdict verdict);

/// The edges that may be false.
enum class Suspects : std::uint8_t {
  kLoopClosures,  ///< those of a pose graph; all other edges are trusted
  kAll            ///< the edges of any graph: pose graphs, landmarks, registration, bundle adjustment
};

/// The verdict on one edge.
struct EdgeVerdict {
  EdgeRef edge;
  /// The ids of the poses of a loop closure, the lower one first; of other edges, the ids of the first and
  /// the last vertex.
  Id from = 0, to = 0;
  Verdict verdict = Verdict::kUndecided;
  double weight = 0;  ///< the factor of its Ω in the final run: 1 if it takes part, otherwise 0
  double chi2 = 0;    ///< eᵀΩe at the final estimates
  /// Whether a loop closure agrees with a neighboring closure: the cycle through both closures and the
  /// odometry between their ends closes, to within the uncertainty. Always false if all edges are suspects.
  bool supported = false;
};

struct OutlierOptions {
  /// The options of all runs. `level` and `edges` choose the edges to use and to judge. `max_iterations` has
  /// no effect on the search, because only the final run counts iterations. `start` has no effect if the
  /// search starts from odometry. `callback` is called by the final run. `time_limit_s` limits each run and,
  /// if all edges are suspects, the search, and `stop` ends the search. `vertices` must be empty.
  Options options = {};
  Suspects suspects = Suspects::kLoopClosures;
  /// The probability that the chi2 of a true edge with Gaussian noise exceeds the limit above which an
  /// edge is rejected. In (1e-9, 1).
  double false_alarm = 2e-4;
  /// The evidence for a closure, as the natural logarithm of an odds ratio, above which it counts as certain.
  /// The odds compare "true" with "anywhere on the map". Positive.
  double evidence = 9;
  /// Two closures can support each other if neither their first nor their second poses are further apart
  /// than this, in poses along the odometry. At least 1.
  int window = 40;
};

struct [[nodiscard]] OutlierReport {
  Suspects suspects = Suspects::kLoopClosures;
  Report report;                      ///< of the final run, in which only the accepted edges take part
  std::vector<EdgeVerdict> verdicts;  ///< one for each suspect, in the order of Graph::all_edges()
  /// The factor of the noise variances that explains the accepted suspects. If it is 1, all Ω fit the errors.
  double noise_scale = 1;
  double time_s = 0;  ///< of the search and the final run; report.time is of the final run only
  /// One sentence about a limitation of the result, or empty.
  std::string note;

  std::size_t count(Verdict verdict) const;
  /// The suspects with this verdict.
  std::vector<EdgeRef> edges(Verdict verdict) const;
};

/// Optimizes a graph without its false edges, and restores their kernels and enabled flags; no edge is
/// removed. Disabled edges are ignored. Throws InvalidArgument if `options` are out of their ranges.
///
/// Suspects::kLoopClosures, for pose graphs. A closure is an edge that measures the full motion between two
/// poses that are not neighbors in the order of ids, and whose Ω is regular. Other edges are trusted: most of
/// the odometry, observations of landmarks, priors. Half of the closures may be false, and false closures may
/// agree with each other in small groups. The method:
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
/// Three kinds of odometry edges are judged as well: edges between the same two neighbors that contradict
/// each other; an edge that contradicts many closures, which agree with each other; and edges with far larger
/// errors than the others. An edge of the last two kinds is a suspect if more closures fit without it. If
/// many closures that agree with each other remain rejected, `report` is not converged
/// (Report::Reason::kRejectedEdges), and `note` says why.
///
/// If a gap in the odometry divides the poses into parts, supported closures connect these parts. If there
/// are none, the gap is bridged by closures that cannot be judged: they are kept with Verdict::kUndecided and
/// weight 1, and `note` says so.
///
/// Throws InvalidArgument if the graph has closures but no odometry.
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
///
/// Suspects::kAll, for graphs of all kinds. Σ min(e², c²) is minimized instead of Σ e² = Σ eᵀΩe, where c² is
/// the limit of OutlierOptions::false_alarm for the rows of the edge, times the scale of the noise if this
/// exceeds one. The scale of the noise is such that half of the accepted edges are below their median. If it
/// is below 1/250, c² becomes smaller at the end: 250 times that scale. The sum is minimized through a
/// sequence of functions, of which the first one grows like |e| and the last one is min(e², c²) (graduated
/// non-convexity: Yang et al., RA-L 2020). The starts are the result of the search for false loop closures,
/// if there is odometry, and Options::start; the result counts in which the accepted edges are most likely.
/// An edge is an outlier if e² > c² at the end. If no more rows than needed measure a vertex, its edges are
/// undecided, because they fit whatever they measure. If more than half of the edges are rejected, `report`
/// is not converged (Report::Reason::kRejectedEdges). Takes about as long as 30 to 60 iterations, plus that
/// search and the final run.
OutlierReport find_outliers(Graph& graph, const OutlierOptions& options = {});

}  // namespace boxplus
