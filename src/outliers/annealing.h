// SPDX-License-Identifier: BSD-3-Clause
// Judges edges of all kinds by their errors, with truncated least squares that begins convex.
//
// Yang, Antonante, Tzoumas & Carlone, "Graduated non-convexity for robust spatial perception: from
// non-minimal solvers to global outlier rejection", RA-L 2020: the sum of min(e², c²) is minimized through a
// sequence of surrogates. The first ones hardly distinguish true edges from false ones; the last one is
// min(e², c²) itself. c² is a quantile of the chi2 distribution for the rows of the edge.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/outliers/outliers.h"
#include "graph/snapshot.h"

namespace boxplus::outliers {

/// The surrogate of min(e², c²) for the parameter μ > 0:
///   ρ(e²) = e²                             for e² ≤ c² μ/(μ + 1)
///           2 c √(e² μ (μ + 1)) − μ (c² + e²)   in between
///           c²                             for e² ≥ c² (μ + 1)/μ
/// For small μ, it grows like |e|; for μ → ∞, it is min(e², c²).
double annealed_weight(double e2, double c2, double mu);

class Annealing {
 public:
  /// Judges the enabled edges of options.level among options.edges. Keeps references to both arguments.
  Annealing(Graph& graph, const OutlierOptions& options);
  /// Restores the kernels.
  ~Annealing();
  Annealing(const Annealing&) = delete;
  Annealing& operator=(const Annealing&) = delete;

  /// Whether there are edges to judge.
  bool has_edges() const { return !state_.edges.empty(); }
  /// The first surrogate for kConvex is nearly convex. For kNear, edges with errors far above their limits
  /// have no weight, and take no part before the end. kTrustingOmega is kConvex with limits that do not grow
  /// if most errors are larger than Ω allows.
  enum class Begin : std::uint8_t { kConvex, kNear, kTrustingOmega };
  /// Minimizes the surrogates from the estimates that `start` finds. Then accepts the edges below their
  /// limits and optimizes with them, until nothing changes. Of all results, the most likely one counts.
  void minimize_from(const std::function<void()>& start, Begin begin);
  /// Whether most errors of the best result are much larger than Ω allows.
  bool is_noisy() const;
  /// Whether so many edges do not fit the best result that another start may lead to a better one.
  bool is_doubtful() const;
  /// The fraction of these edges that do not fit the best result.
  double rejected_share(std::span<const EdgeRef> edges) const;
  /// Optimizes with the accepted edges, by the options of the caller, and judges all edges.
  OutlierReport finish();

 private:
  struct Edge {
    EdgeRef edge;
    int rows = 0;
    double quantile = 0, median = 0;  // of chi2
    double chi2 = 0;                  // at the current estimates
    bool accepted = true;
    std::shared_ptr<const RobustKernel> kernel;  // of the caller
  };

  struct Rows {
    double accepted = 0, rejected = 0, redundant = 0;  ///< redundant: beyond the degrees of freedom
  };
  struct State {
    std::vector<Edge> edges;
    std::vector<double> weights;  // of the last surrogate
    double noise_scale = 1, limit_scale = 1;
  };

  bool was_stopped() const;
  double limit(const Edge& edge) const { return edge.quantile * state_.limit_scale; }
  void measure();
  void go_to(const std::function<void()>& start);
  void anneal(double mu);
  void settle();
  void keep_if_better();
  void tighten_limits();
  Rows rows() const;
  double cost() const;
  int free_dim(const VertexRef& vertex) const;
  double change_weights(double mu);
  void run();
  double largest_ratio() const;
  void restore();
  void hold_lost_vertices(std::vector<std::uint8_t>& fits) const;
  std::vector<std::uint8_t> has_redundancy() const;
  OutlierReport judge(Report report, bool stopped) const;

  Graph& graph_;
  const OutlierOptions& options_;
  std::optional<Optimizer> optimizer_;
  const Stopwatch watch_;
  bool trusts_omega_ = false;
  State state_;
  std::optional<State> best_;
  double best_cost_ = 0;
  Snapshot initial_estimates_, best_estimates_;
  std::vector<std::vector<VertexRef>> vertices_;            // of each edge, without parameters
  std::map<VertexRef, std::vector<std::size_t>> incident_;  // the edges of each free vertex
};

}  // namespace boxplus::outliers
