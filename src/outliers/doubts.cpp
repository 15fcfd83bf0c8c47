// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/doubts.h"

#include <fmt/format.h>

#include <algorithm>

namespace boxplus::outliers {

void mark_as_stopped(Report& report, const Options& options) {
  if (!report.converged()) return;
  const bool by_flag = options.stop != nullptr && options.stop->load();
  report.status = Report::Status::kNotConverged;
  report.reason = by_flag ? Report::Reason::kStopFlag : Report::Reason::kTimeLimit;
  report.message =
      by_flag ? "the search for false edges was stopped" : "the time limit ended the search for false edges";
}

void doubt_if_most_are_rejected(OutlierReport& result) {
  constexpr double kMost = 0.6;  // half of them may be false, and some true ones without evidence
  const auto count = result.verdicts.size();
  const auto rejected = std::count_if(
      result.verdicts.begin(), result.verdicts.end(),
      [](const EdgeVerdict& edge) { return edge.verdict == Verdict::kOutlier && edge.weight == 0; });
  if (static_cast<double>(rejected) <= kMost * static_cast<double>(count)) return;
  if (result.note.empty())
    result.note = "most loop closures do not fit, so the odometry may be wrong, or Ω by orders of magnitude";
  doubt(result, fmt::format("{} of the {} loop closures were rejected", rejected, count));
}

void doubt(OutlierReport& result, const std::string& message) {
  if (result.note.empty()) result.note = message;
  if (!result.report.converged()) return;
  result.report.status = Report::Status::kNotConverged;
  result.report.reason = Report::Reason::kRejectedEdges;
  result.report.message = message;
}

}  // namespace boxplus::outliers
