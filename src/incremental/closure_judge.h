// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on loop closures while a graph grows.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "boxplus/graph/change_log.h"
#include "boxplus/graph/graph.h"
#include "boxplus/incremental/smoother_options.h"

namespace boxplus {

/// Copies the estimates of all vertices that are not fixed from a copy of the graph.
void take_estimates(Graph& graph, const Graph& copy);

/// Knows which closures are set aside. A new closure is judged by its predicted cost alone, and all closures
/// together are judged again by find_outliers() each time that their number has grown by a part, so that the
/// searches for a whole drive together cost a few times as much as the last one.
class ClosureJudge {
 public:
  /// The edges that take no part.
  const std::set<EdgeRef>& aside() const { return aside_; }
  /// Sets the new closures among these edges aside until they are judged, and returns them. A closure is an
  /// edge that measures the full motion between two poses that are not neighbors in the order of ids.
  std::vector<EdgeRef> hold_closures(const Graph& graph, const detail::ChangeLog& log);
  /// Takes an edge back without a verdict, because it is needed.
  void take_back(EdgeRef edge) { aside_.erase(edge); }
  /// Judges a new closure by EdgePreview::chi2_increase. Returns false if it is set aside.
  bool accepts(EdgeRef edge, const EdgePreview& preview, double false_alarm);
  /// Whether enough has changed for a search; `finishes`: whether anything has.
  bool is_search_due(bool finishes) const;
  /// A copy of the graph without the edges that are disabled or set aside.
  Graph copy_without_aside(const Graph& graph) const;
  /// Judges all closures of the graph. Returns the edges whose verdicts have changed. If there are any, moves
  /// the estimates of the graph to those of the search.
  std::vector<EdgeRef> search(Graph& graph, double false_alarm, const std::atomic<bool>* stop);
  /// Says that there cannot be a search now.
  void give_up_search() { judged_ = rejected_ = 0, is_new_ = false; }
  /// Says that closures were judged by nobody yet, as those of a graph that did not grow.
  void expect_search() { is_new_ = true; }

 private:
  bool is_closure(const Graph& graph, EdgeRef edge) const;

  std::set<EdgeRef> aside_;
  std::map<Id, VertexRef> poses_;
  double noise_scale_ = 1;
  std::uint32_t judged_ = 0, rejected_ = 0;  // since the last search
  std::uint32_t at_search_ = 0;              // the number of closures then
  bool is_new_ = false;
};

}  // namespace boxplus
