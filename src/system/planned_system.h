// SPDX-License-Identifier: BSD-3-Clause
// Owns the System of a graph, and adapts it when the graph's structure or the options change.
#pragma once

#include <memory>
#include <vector>

#include "system/batch_system.h"

namespace boxplus {

class PlannedSystem {
 public:
  /// How the last update() obtained the plan.
  enum class Origin : std::uint8_t { kMade, kExtended, kReused };
  /// Brings the plan up to date. Throws Stopped if `stop` is raised while the plan has to change; the next
  /// call then makes a new plan.
  Origin update(Graph& graph, const Options& options, const StopToken& stop);

  /// Whether update() would reuse the plan.
  bool is_current(const Graph& graph, const Options& options) const {
    return system_ != nullptr && suits(options) && revision_ == graph.revision();
  }

  /// Valid after update().
  BatchSystem& system() { return *system_; }
  const BatchSystem& system() const { return *system_; }

 private:
  bool suits(const Options& options) const;
  bool extend(Graph& graph, const StopToken& stop);
  void make(Graph& graph, const Options& options, const StopToken& stop);
  void note_structure(const Graph& graph);
  PlanRequest request(const StopToken& stop) const;

  std::unique_ptr<BatchSystem> system_;
  Options options_;             // the options for which the plan was made
  std::uint64_t revision_ = 0;  // the revision of the graph at the last update
  PlannedElements elements_;    // the elements of the graph at that revision
};

/// Options::threads, with 0 replaced by the number of hardware threads.
int resolved_threads(const Options& options);

}  // namespace boxplus
