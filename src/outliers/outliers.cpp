// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/outliers/outliers.h"

#include <algorithm>

namespace boxplus {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kInlier:
      return "inlier";
    case Verdict::kOutlier:
      return "outlier";
    default:
      return "undecided";
  }
}

std::size_t OutlierReport::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::count_if(
      verdicts.begin(), verdicts.end(), [&](const EdgeVerdict& edge) { return edge.verdict == verdict; }));
}

std::vector<EdgeRef> OutlierReport::edges(Verdict verdict) const {
  std::vector<EdgeRef> result;
  for (const EdgeVerdict& edge : verdicts) {
    if (edge.verdict == verdict) result.push_back(edge.edge);
  }
  return result;
}

}  // namespace boxplus
