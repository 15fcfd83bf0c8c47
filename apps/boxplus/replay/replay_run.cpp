// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay_run.h"

#include <algorithm>

namespace boxplus::app {

SmootherReport Replay::step() {
  SmootherReport report = count(smoother_.update());
  seconds_.push_back(report.time_s);
  return report;
}

SmootherReport Replay::finish() {
  return count(smoother_.finish());
}

SmootherReport Replay::count(const SmootherReport& report) {
  totals_.seconds += report.time_s;
  totals_.flops += report.flops;
  totals_.iterations += static_cast<std::uint64_t>(report.iterations);
  totals_.relinearized += report.relinearized;
  totals_.ordered += report.ordered;
  totals_.refactored += report.refactored;
  totals_.moved += report.moved;
  totals_.started_over += report.started_over ? 1 : 0;
  return report;
}

double Replay::chi2() const {
  double sum = 0;
  const std::vector<EdgeRef> aside = smoother_.set_aside();  // sorted
  for (const EdgeRef& edge : graph_.all_edges()) {
    const bool takes_part = graph_.level(edge) == 0 && graph_.is_enabled(edge) &&
                            !std::binary_search(aside.begin(), aside.end(), edge);
    if (!takes_part) continue;
    const RobustKernel* const kernel = graph_.kernel(edge);
    const double e2 = graph_.chi2(edge);
    sum += kernel != nullptr ? (*kernel)(e2).value : e2;
  }
  return sum;
}

}  // namespace boxplus::app
