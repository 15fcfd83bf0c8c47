// SPDX-License-Identifier: BSD-3-Clause
// Which vertices a smoother with a fixed lag still keeps.
#pragma once

#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// The vertices that have a time, in the order of their times. A vertex has the time that it was given, or
/// otherwise, if it is a pose, the time of the newest vertex before it.
class LagWindow {
 public:
  /// Gives a vertex a time. Vertices with equal times leave in the order of these calls.
  void set_time(VertexRef vertex, double seconds);
  /// Takes a vertex into the window if it has no time yet and is a pose.
  void add(const Graph& graph, VertexRef vertex);
  bool contains(VertexRef vertex) const { return time_of_.contains(vertex); }
  /// Removes and returns the oldest vertices, so that at most `count` remain, and none that is more than
  /// `seconds` older than the newest one. Forgets vertices that the graph does not have any more.
  std::vector<VertexRef> take_leaving(const Graph& graph, std::size_t count, double seconds);

 private:
  using Key = std::pair<double, std::uint64_t>;  // the time, and the number of the call
  std::map<Key, VertexRef> by_time_;
  std::map<VertexRef, Key> time_of_;
  std::uint64_t calls_ = 0;
};

}  // namespace boxplus
