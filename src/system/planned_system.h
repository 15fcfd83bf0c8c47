// SPDX-License-Identifier: BSD-3-Clause
// Owns the System of a graph, and makes a new one when the graph's structure or the options change.
#pragma once

#include <cstdint>
#include <memory>

#include "system/batch_system.h"

namespace boxplus {

class PlannedSystem {
 public:
  /// Brings the plan up to date. Returns true if it reuses the plan, and false if it makes a new one. Throws
  /// Stopped if `stop` is raised while the plan has to change; the next call then makes a new plan.
  bool update(Graph& graph, const Options& options, const StopToken& stop);

  /// Whether update() would reuse the plan.
  bool is_current(const Graph& graph, const Options& options) const {
    return system_ != nullptr && suits(options) && revision_ == graph.revision();
  }

  /// Valid after update().
  BatchSystem& system() { return *system_; }
  const BatchSystem& system() const { return *system_; }

 private:
  bool suits(const Options& options) const;
  void make(Graph& graph, const Options& options, const StopToken& stop);
  PlanRequest request(const StopToken& stop) const;

  std::unique_ptr<BatchSystem> system_;
  Options options_;             // the options for which the plan was made
  std::uint64_t revision_ = 0;  // the revision of the graph when the plan was made
};

/// Options::threads, with 0 replaced by the number of hardware threads.
int resolved_threads(const Options& options);

}  // namespace boxplus
