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
  /// The session of `graph` for these options; `reused` tells whether it was there already.
  static Session& find(Graph& graph, const Options& options, bool& reused);

  BatchSystem& system() { return *system_; }
  /// While it is in use, find() throws InvalidArgument.
  void set_in_use(bool in_use) { in_use_ = in_use; }
  Algorithm& algorithm(const Options& options);

 private:
  bool fits(const Graph& graph, const Options& options) const;
  bool has_precision(Precision wanted) const;
  void plan(Graph& graph);

  std::uint64_t revision_ = 0;
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
