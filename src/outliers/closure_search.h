// SPDX-License-Identifier: BSD-3-Clause
// Accepts closures in stages, beginning with the odometry.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boxplus/outliers/outliers.h"
#include "outliers/cycle_test.h"

namespace boxplus::outliers {

class ClosureSearch {
 public:
  /// Keeps references to all arguments.
  ClosureSearch(Graph& graph, const PoseGraph& poses, const OdometryChain& chain, const CycleTests& cycles,
                const Evidence& evidence, const OutlierOptions& options);

  /// Whether so many closures are supported, and so few contradict the odometry, that all of them may be
  /// true.
  bool may_accept_all() const;
  /// Optimizes the graph with all closures. Returns whether they all fit; then all of them are accepted.
  bool accept_all();
  /// Accepts closures in stages, and optimizes the graph with the accepted edges. Begins with the odometry.
  void accept_in_stages();
  /// Compares all closures with the estimates and optimizes, until nothing changes.
  void settle();
  /// Optimizes the graph with the accepted edges, by the options of the caller.
  Report finish();

  /// The verdicts at the current estimates. If many closures cannot be judged, note() says so.
  std::vector<EdgeVerdict> verdicts();
  /// The scale of the noise that explains the accepted closures.
  double noise_scale() const;
  const std::string& note() const { return note_; }
  /// Whether Options::stop ended the search.
  bool was_stopped() const { return options_.options.stop != nullptr && options_.options.stop->load(); }

 private:
  struct Needed {
    double by_group, by_lone;
  };

  bool is_supported(std::size_t closure) const { return cycles_.support[closure] >= options_.evidence; }
  void note_progress() const;
  bool may_add(std::size_t closure) const;
  double group_bonus(std::size_t closure) const;
  void bridge_gaps();
  std::size_t add_certain(std::span<const Deviation> deviations, double scale);
  bool add_on_trial(std::span<const Deviation> deviations);
  Needed needed_on_trial() const;
  void eject(int penalty);
  bool reconsider(bool may_add);
  std::vector<Deviation> deviations(std::uint32_t trees) const;
  std::size_t accepted_count() const;
  std::vector<const PoseEdge*> accepted_edges() const;
  Report optimize_accepted(Options options);
  void optimize_briefly(int iterations, Start start = Start::kCurrent);
  void measure();
  double degrees_of_freedom() const;
  double limit_of_result(std::size_t closure) const;
  double limit(std::size_t closure) const { return quantile_[closure] * limit_scale_; }

  Graph& graph_;
  const PoseGraph& poses_;
  const OdometryChain& chain_;
  const CycleTests& cycles_;
  const Evidence& evidence_;
  const OutlierOptions& options_;
  std::vector<std::uint8_t> accepted_, is_bridge_;
  std::vector<int> ejections_;
  std::vector<double> chi2_;               // at the current estimates
  std::vector<double> quantile_, median_;  // of chi2, for the rows of each closure
  double noise_scale_ = 1;                 // at the last measure()
  double limit_scale_ = 1;                 // the factor of the quantiles that gives the limits
  std::optional<Report> all_accepted_;
  std::string note_;
};

}  // namespace boxplus::outliers
