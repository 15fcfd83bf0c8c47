// SPDX-License-Identifier: BSD-3-Clause
// What optimize() keeps in a graph between calls: the plan, the memory, the algorithms.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "boxplus/optimize/algorithm.h"
#include "boxplus/optimize/batch_system.h"

namespace boxplus {

class Session final : public Graph::Cache {
 public:
  /// Where the plan comes from.
  enum class Origin : std::uint8_t { kMade, kExtended, kReused };
  /// The session of `graph` for these options. Throws Stopped once `stop` is raised and the plan is to be
  /// changed; the next call makes a new one then.
  static Session& find(Graph& graph, const Options& options, const StopToken& stop, Origin& origin);

  BatchSystem& system() { return *system_; }
  /// While it is in use, find() throws InvalidArgument.
  void set_in_use(bool in_use) { in_use_ = in_use; }
  Algorithm& algorithm(const Options& options);

 private:
  bool suits(const Options& options) const;
  bool extend(Graph& graph, const StopToken& stop);
  void note_structure(const Graph& graph);
  PlanRequest request(const StopToken& stop) const;
  bool has_precision(Precision wanted) const;
  void plan(Graph& graph, const StopToken& stop);

  std::uint64_t revision_ = 0;
  std::vector<std::uint32_t> vertex_slots_, edge_slots_;  // of each pool, at that revision
  int level_ = 0, threads_ = 1;
  GaugePolicy gauge_ = GaugePolicy::kFixFirst;
  LinearSolverKind solver_ = LinearSolverKind::kAutomatic;
  std::shared_ptr<LinearSolver> own_solver_;
  SchurMode schur_ = SchurMode::kAutomatic;
  std::uint64_t max_factor_bytes_ = 0;
  Precision precision_ = Precision::kAutomatic;
  std::vector<VertexRef> vertices_;
  std::vector<EdgeRef> edges_;
  bool in_use_ = false;
  std::unique_ptr<BatchSystem> system_;
  std::array<std::unique_ptr<Algorithm>, 4> algorithms_;
};

/// Options::threads with 0 resolved.
int resolved_threads(const Options& options);

}  // namespace boxplus
