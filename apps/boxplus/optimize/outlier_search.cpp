// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/outlier_search.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace boxplus::app {

std::string verdicts_text(const OutlierReport& found) {
  const std::size_t all = found.verdicts.size(), outliers = found.count(Verdict::kOutlier),
                    undecided = found.count(Verdict::kUndecided);
  const char* const kind = found.suspects == Suspects::kAll ? "edge" : "loop closure";
  std::string text = fmt::format("{} of {} {}{} {} false", outliers, all, kind, all == 1 ? "" : "s",
                                 outliers == 1 || all == 1 ? "is" : "are");
  if (undecided > 0) text += fmt::format(", and {} {} undecided", undecided, undecided == 1 ? "is" : "are");
  return text;
}

std::string outliers_text(const OutlierReport& found) {
  std::string text = verdicts_text(found);
  text += found.suspects == Suspects::kAll ? "; the report is about the edges that fit.\n"
                                           : "; the report is about the others and all other edges.\n";
  text += fmt::format("The search and this run took {:.4f} s.\n", found.time_s);
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

nlohmann::ordered_json outliers_json(const OutlierReport& found) {
  nlohmann::ordered_json edges = nlohmann::ordered_json::array();
  for (const EdgeVerdict& edge : found.verdicts) {
    edges.push_back({{"from", edge.from},
                     {"to", edge.to},
                     {"verdict", to_string(edge.verdict)},
                     {"weight", edge.weight},
                     {"chi2", edge.chi2},
                     {"supported", edge.supported}});
  }
  return {{"inliers", found.count(Verdict::kInlier)},
          {"outliers", found.count(Verdict::kOutlier)},
          {"undecided", found.count(Verdict::kUndecided)},
          {"noise_scale", found.noise_scale},
          {"note", found.note},
          {found.suspects == Suspects::kAll ? "edges" : "closures", edges}};
}

void remove_outliers(Graph& graph, const OutlierReport& found) {
  const bool removes_undecided = found.suspects == Suspects::kAll;
  for (const EdgeVerdict& edge : found.verdicts) {
    if (edge.verdict == Verdict::kOutlier || (removes_undecided && edge.weight == 0)) graph.remove(edge.edge);
  }
}

}  // namespace boxplus::app
