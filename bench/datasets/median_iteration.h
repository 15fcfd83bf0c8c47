// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/base/error.h"
#include "boxplus/optimize/report.h"
#include "datasets/median.h"

namespace boxplus::bench {

/// Returns the median time of an iteration. The first iteration is not counted.
inline double median_iteration(const Report& report) {
  std::vector<double> seconds;
  for (std::size_t k = 1; k < report.records.size(); ++k)
    seconds.push_back(report.records[k].time_s - report.records[k - 1].time_s);
  if (seconds.empty()) throw InvalidArgument("expected at least two iterations");
  return median(std::move(seconds));
}

}  // namespace boxplus::bench
