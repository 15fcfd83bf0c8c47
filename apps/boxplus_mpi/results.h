// SPDX-License-Identifier: BSD-3-Clause
// Collects the estimates of all processes in the graph of the first one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

/// The vertices of a process's own edges, and their estimates before the run.
class Results {
 public:
  Results(const Graph& graph, std::span<const EdgeRef> own_edges);
  /// Of each of these vertices that has moved: its id, its size, and the δ for which before ⊞ δ is its
  /// estimate.
  std::vector<std::uint64_t> changes(const Graph& graph) const;

 private:
  struct Pool {
    std::vector<std::uint32_t> slots;                // ascending
    std::unique_ptr<detail::SavedEstimates> before;  // of `slots`
  };
  std::vector<Pool> pools_;
};

/// Applies the changes of all processes to a graph with the estimates before the run.
class ChangedGraph {
 public:
  static constexpr std::size_t kHeader = 2;  ///< the words of a change before δ: id and size

  /// `is_part`: changes of vertices that the graph does not have are left out.
  explicit ChangedGraph(Graph& graph, bool is_part = false);
  /// Applies the changes of one process. Leaves out vertices that have changed already, because a vertex of
  /// several processes has the same change in all of them. Throws InvalidArgument if the graph is another
  /// one.
  void apply(std::span<const std::uint64_t> changes);

 private:
  Graph& graph_;
  bool is_part_;
  std::vector<std::vector<bool>> has_changed_;  // by vertex pool and slot
};

}  // namespace boxplus::app
