// SPDX-License-Identifier: BSD-3-Clause
// Collects the estimates of all processes in the graph of the first one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "communicator.h"

namespace boxplus::app {

/// Every process has the whole graph, and moves the vertices of its own edges.
class Results {
 public:
  /// Keeps the estimates before the run.
  Results(const Graph& graph, std::span<const EdgeRef> own_edges);
  /// Sets the vertices of the first process's graph that only other processes have moved. Collective.
  void collect(Graph& graph, mpi::Communicator& communicator) const;

 private:
  struct Pool {
    std::vector<std::uint32_t> slots;
    std::vector<std::uint8_t> own;                   // whether an own edge has the vertex, by slot
    std::unique_ptr<detail::SavedEstimates> before;  // of `slots`
    std::unique_ptr<detail::VertexPool> same;        // the same, as a pool
  };
  std::vector<std::uint64_t> changes(const Graph& graph) const;
  void leave_own(Graph& graph) const;

  std::vector<Pool> pools_;
};

}  // namespace boxplus::app
