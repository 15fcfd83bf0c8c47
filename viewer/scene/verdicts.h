// SPDX-License-Identifier: BSD-3-Clause
// The verdicts of the last run on the edges of a graph.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/outliers/outliers.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

class Verdicts {
 public:
  Verdicts() = default;
  explicit Verdicts(std::span<const EdgeVerdict> verdicts);

  bool empty() const { return verdicts_.empty(); }
  /// None if the edge was no suspect. O(log n).
  std::optional<Verdict> of(EdgeRef edge) const;
  /// The suspects with this verdict, sorted.
  std::vector<EdgeRef> edges(Verdict verdict) const;

 private:
  std::vector<std::pair<EdgeRef, Verdict>> verdicts_;  // sorted
};

/// For each line: 0 if its edge was no suspect, 1 for inliers, 2 for undecided edges, 3 for outliers. Empty
/// if there are no verdicts.
std::vector<std::uint8_t> verdicts_of_lines(const Graph& graph, const Structure& structure,
                                            const Verdicts& verdicts);

}  // namespace boxplus::viewer
