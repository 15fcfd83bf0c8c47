// SPDX-License-Identifier: BSD-3-Clause
// Updates a Smoother step by step, and keeps the records of a replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/incremental/smoother.h"

namespace boxplus::app {

class Replay {
 public:
  /// `graph` must outlive this object.
  Replay(Graph& graph, const SmootherOptions& options) : graph_(graph), smoother_(graph, options) {}

  /// The number of steps.
  std::size_t done() const { return seconds_.size(); }
  /// Does a step: updates the estimates.
  SmootherReport step();
  /// Brings the estimates to the optimum to the last digits.
  SmootherReport finish();
  Smoother& smoother() { return smoother_; }
  /// The time of each step, in seconds.
  const std::vector<double>& seconds() const { return seconds_; }
  /// chi2 of the edges that take part now.
  double chi2() const;

  /// The sums over all updates.
  struct Totals {
    double seconds = 0, flops = 0;
    std::uint64_t iterations = 0, relinearized = 0, ordered = 0, refactored = 0, moved = 0;
    std::uint32_t started_over = 0;
  };
  const Totals& totals() const { return totals_; }

 private:
  SmootherReport count(const SmootherReport& report);

  Graph& graph_;
  Smoother smoother_;
  std::vector<double> seconds_;
  Totals totals_;
};

}  // namespace boxplus::app
