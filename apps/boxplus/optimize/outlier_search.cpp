// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/outlier_search.h"

#include <fmt/format.h>

namespace boxplus::app {

std::string outliers_text(const OutlierReport& found) {
  const std::size_t all = found.verdicts.size(), outliers = found.count(Verdict::kOutlier),
                    undecided = found.count(Verdict::kUndecided);
  std::string text = fmt::format("{} of {} loop closure{} {} false", outliers, all, all == 1 ? "" : "s",
                                 outliers == 1 ? "is" : "are");
  if (undecided > 0) text += fmt::format(", and {} {} undecided", undecided, undecided == 1 ? "is" : "are");
  text += "; the report is about the others and all other edges.\n";
  if (!found.note.empty()) text += fmt::format("Note: {}.\n", found.note);
  return text;
}

std::string outliers_list(const OutlierReport& found) {
  std::string text = "# verdict from to chi2\n";
  for (const EdgeVerdict& edge : found.verdicts) {
    if (edge.verdict != Verdict::kInlier)
      text += fmt::format("{} {} {} {:.6g}\n", to_string(edge.verdict), edge.from, edge.to, edge.chi2);
  }
  return text;
}

void remove_outliers(Graph& graph, const OutlierReport& found) {
  for (const EdgeRef& edge : found.edges(Verdict::kOutlier)) graph.remove(edge);
}

}  // namespace boxplus::app
