// SPDX-License-Identifier: BSD-3-Clause
// Signs of a run that is stuck far from the minimum.
#pragma once

#include <array>
#include <cstddef>

#include "system/run_system.h"

namespace boxplus {

/// Notices that chi2 hardly falls although the run goes on.
class Crawl {
 public:
  /// To be called with the chi2 after each iteration. Returns whether the last ten iterations lowered chi2 by
  /// less than one percent.
  bool is_noticed(double chi2) {
    constexpr double kLeast = 0.01;
    double& before = chi2_[count_++ % chi2_.size()];
    const bool is_noticed = count_ > chi2_.size() && chi2 > (1 - kLeast) * before;
    before = chi2;
    return is_noticed;
  }

 private:
  std::array<double, 10> chi2_{};
  std::size_t count_ = 0;
};

/// Whether a few enabled active edges have most of chi2. If noise alone makes chi2 large, because Ω is too
/// large, all edges have similar shares. O(edges).
bool few_edges_dominate(const Graph& graph, const RunSystem& system);

}  // namespace boxplus
